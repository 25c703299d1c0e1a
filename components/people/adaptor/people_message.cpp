#include "components/people/adaptor/people_message.hpp"

#include <cmath>
#include <optional>

#include "runtime/stamps.hpp"

namespace bw::people {

ReadPeople read_people(const people_msgs::msg::People& message, Time now, double timeout,
                       const std::string& odom_frame, const TransformTree& transforms) {
  const Time stamp = from_stamp(message.header().stamp());
  const std::string& frame = message.header().frame_id();
  if (stamp <= Time{}) return {"it has no stamp", {}};
  if (std::abs((now - stamp).to_seconds()) > timeout) return {"its stamp is not of now", {}};
  std::optional<Pose2> X_OF;
  if (frame == odom_frame) X_OF = Pose2{};
  if (!X_OF) X_OF = transforms.lookup_planar(odom_frame, frame, stamp);
  if (!X_OF) X_OF = transforms.lookup_planar(odom_frame, frame);
  if (!X_OF) return {"no transform from '" + frame + "' to " + odom_frame, {}};
  ReadPeople read{{}, {stamp, {}}};
  for (const auto& person : message.people()) {
    read.heard.people.push_back(
        {.name = person.name(),
         .position = *X_OF * Vector2(person.position().x(), person.position().y()),
         .velocity = rotate(*X_OF, Vector2(person.velocity().x(), person.velocity().y())),
         .reliability = person.reliability()});
  }
  return read;
}

}  // namespace bw::people
