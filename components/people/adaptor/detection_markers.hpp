// What the detector saw as markers for rviz2.
#pragma once

#include <visualization_msgs/msg/marker_array.hpp>

#include "components/people/detection.hpp"
#include "runtime/base/time.hpp"

namespace bw::people {

/// Low discs: legs green, two legs in one blue, the more opaque the likelier; background and what is nobody
/// grey. Outlines that are no more than walls are left out. Those of a second laser are `legs_1`.
visualization_msgs::msg::MarkerArray to_markers(const DetectionSet& detections, Duration lifetime,
                                                const std_msgs::msg::Header& header);

}  // namespace bw::people
