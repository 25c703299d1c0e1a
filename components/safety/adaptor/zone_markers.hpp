// The robot's outline and its zones for rviz2 and Foxglove. Pure conversion.
#pragma once

#include <visualization_msgs/msg/marker_array.hpp>

#include "components/safety/collision_monitor.hpp"

namespace bw::safety {

/// In base_link: namespace `footprint` is the outline that must stay free (green, yellow while limited, red
/// at a stop) with the cause written above; `zones` the outlines of the enabled zones, the one that is the
/// cause in the same colour.
visualization_msgs::msg::MarkerArray to_markers(const CollisionMonitorOptions& options,
                                                const Footprint& kept_free, const Verdict& verdict,
                                                const std_msgs::msg::Header& header);

}  // namespace bw::safety
