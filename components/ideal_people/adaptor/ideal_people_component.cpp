// People perception that cannot err (beyond the noise asked for): the world's truth as tracks, until a real
// one takes its place.
#include <optional>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/ground_truth.hpp>

#include "components/ideal_people/ideal_tracks.hpp"
#include "components/ideal_people/velocity_memory.hpp"
#include "components/messages/geometry.hpp"
#include "components/messages/people.hpp"
#include "runtime/component.hpp"

namespace bw {
namespace {

std::vector<Mover> people_of(const bandwagon_msgs::msg::GroundTruth& truth) {
  std::vector<Mover> people;
  people.reserve(truth.people().size());
  for (const auto& person : truth.people()) {
    people.push_back({.id = person.id(),
                      .position = {person.position().x(), person.position().y()},
                      .velocity = {person.velocity().x(), person.velocity().y()},
                      .radius = person.radius()});
  }
  return people;
}

class IdealPeopleComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    options_ = setup.parameters<IdealPeopleOptions>();
    random_.emplace(setup.seed());
    period_ = Duration::seconds(1.0 / options_.rate);
    map_frame_ = setup.frame("map");
    tracks_ = setup.output<bandwagon_msgs::msg::Tracks>("tracks");
    people_ = setup.output<people_msgs::msg::People>("people");
    markers_ = setup.output<visualization_msgs::msg::MarkerArray>("people_markers");
    setup.input<bandwagon_msgs::msg::GroundTruth>(
        "sim/ground_truth", Qos::standard(), [this](const auto& message, const Tick&) { on_truth(message); });
  }

 private:
  void on_truth(const bandwagon_msgs::msg::GroundTruth& truth) {
    const Time stamp = from_stamp(truth.header().stamp());
    if (last_ && stamp >= *last_ && stamp - *last_ < period_) return;
    std::vector<Mover> people = people_of(truth);
    memory_.smooth(people, options_.velocity_memory, last_ ? (stamp - *last_).to_seconds() : 0.0);
    last_ = stamp;
    const Vector2 robot(truth.pose().position().x(), truth.pose().position().y());
    const std::vector<TrackedPerson> tracks = ideal_tracks(people, robot, options_, *random_);
    const std_msgs::msg::Header header = make_header(map_frame_, stamp);
    tracks_.publish(people::to_tracks(tracks, header));
    people_.publish(people::to_people(tracks, header));
    const Duration lifetime = Duration::seconds(2.5 / options_.rate);  // till shortly after the next is due
    if (markers_.has_readers()) markers_.publish(people::to_markers(tracks, lifetime, header));
  }

  IdealPeopleOptions options_;
  std::optional<Random> random_;
  Duration period_;
  std::optional<Time> last_;
  VelocityMemory memory_;
  std::string map_frame_;
  Output<bandwagon_msgs::msg::Tracks> tracks_;
  Output<people_msgs::msg::People> people_;
  Output<visualization_msgs::msg::MarkerArray> markers_;
};

}  // namespace

BW_COMPONENT(IdealPeopleComponent, "ideal_people")

}  // namespace bw
