// People as messages: our own Tracks, people_msgs/People, and markers for rviz2. Pure conversions; `header`
// names the frame that the people are in.
#pragma once

#include <vector>

#include <bandwagon_msgs/msg/tracks.hpp>
#include <people_msgs/msg/people.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "components/model/tracked_person.hpp"
#include "runtime/base/time.hpp"

namespace bw::people {

bandwagon_msgs::msg::Tracks to_tracks(const std::vector<TrackedPerson>& people,
                                      const std_msgs::msg::Header& header);
/// In the frame of the message; what it does not tell, such as when they were seen first, stays empty.
std::vector<TrackedPerson> from_tracks(const bandwagon_msgs::msg::Tracks& message);
people_msgs::msg::People to_people(const std::vector<TrackedPerson>& people,
                                   const std_msgs::msg::Header& header);
/// Cylinders with arrows, of possible people pale ones without; they vanish by themselves after `lifetime`.
visualization_msgs::msg::MarkerArray to_markers(const std::vector<TrackedPerson>& people, Duration lifetime,
                                                const std_msgs::msg::Header& header);

}  // namespace bw::people
