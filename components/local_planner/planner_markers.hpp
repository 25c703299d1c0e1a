// What the planner considered, for rviz2 and Foxglove.
#pragma once

#include <string>

#include <visualization_msgs/msg/marker_array.hpp>

#include "components/model/planning.hpp"

namespace bw {

/// Line strips of all candidates (chosen: green) and the predicted positions of the movers, in frame `frame`.
visualization_msgs::msg::MarkerArray to_markers(const PlanningProblem& problem, const PlanningResult& result,
                                                const std::string& frame);

}  // namespace bw
