// Tracks as messages: our own Tracks, people_msgs/People, and cylinders with arrows for rviz2. Pure
// conversions.
#pragma once

#include <vector>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <people_msgs/msg/people.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "components/ideal_people/ideal_tracks.hpp"

namespace bw {

std::vector<Mover> people_of(const bandwagon_msgs::msg::GroundTruth& truth);

bandwagon_msgs::msg::Tracks to_tracks(const std::vector<Mover>& tracks, const IdealPeopleOptions& options,
                                      const std_msgs::msg::Header& header);
people_msgs::msg::People to_people(const std::vector<Mover>& tracks, const std_msgs::msg::Header& header);
/// Markers vanish by themselves shortly after the next message is due.
visualization_msgs::msg::MarkerArray to_markers(const std::vector<Mover>& tracks, double rate,
                                                const std_msgs::msg::Header& header);

}  // namespace bw
