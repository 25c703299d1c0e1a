// People of another program (people_msgs/People) as values in odom.
#pragma once

#include <string>

#include <people_msgs/msg/people.hpp>

#include "components/people/heard_person.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw::people {

struct ReadPeople {
  std::string fault;  ///< why the message is not used; empty: it is
  HeardSet heard;     ///< in `odom_frame`
};

/// A stamp farther than `timeout` [s] from now, none, and a frame that nobody places are faults. The frame is
/// taken as of the stamp, or as it was last where that is not known.
ReadPeople read_people(const people_msgs::msg::People& message, Time now, double timeout,
                       const std::string& odom_frame, const TransformTree& transforms);

}  // namespace bw::people
