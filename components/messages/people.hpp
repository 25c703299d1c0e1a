// People as messages: our own Tracks, people_msgs/People, and markers for rviz2. Pure conversions.
#pragma once

#include <vector>

#include <bandwagon_msgs/msg/tracks.hpp>
#include <people_msgs/msg/people.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "components/model/obstacles.hpp"
#include "runtime/base/time.hpp"

namespace bw::people {

/// Somebody as messages tell of them, in the frame of the header.
struct ReportedPerson {
  Mover body;
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< of (x, y, vx, vy) [m, m/s]
  double reliability = 1.0;                              ///< 0 to 1
};

bandwagon_msgs::msg::Tracks to_tracks(const std::vector<ReportedPerson>& people,
                                      const std_msgs::msg::Header& header);
people_msgs::msg::People to_people(const std::vector<ReportedPerson>& people,
                                   const std_msgs::msg::Header& header);
/// Cylinders with arrows; they vanish by themselves after `lifetime`.
visualization_msgs::msg::MarkerArray to_markers(const std::vector<ReportedPerson>& people, Duration lifetime,
                                                const std_msgs::msg::Header& header);

}  // namespace bw::people
