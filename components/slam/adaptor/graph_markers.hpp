// The pose graph for people to see, as slam_toolbox shows it.
#pragma once

#include <string>

#include <visualization_msgs/msg/marker_array.hpp>

#include "components/slam/slam.hpp"

namespace bw::slam {

/// Submaps as spheres, the drive and the loops as lines between them. A loop is green where it agrees with the
/// graph, red where it has lost nine tenths of its weight (pose_graph.hpp). It replaces what was shown before.
visualization_msgs::msg::MarkerArray to_markers(const Slam& slam, const Pose2& X_MW, const std::string& frame,
                                                Time stamp);

}  // namespace bw::slam
