// What the planner considered, for rviz2 and Foxglove.
#pragma once

#include <string>

#include <visualization_msgs/msg/marker_array.hpp>

#include "components/model/planning.hpp"

namespace bw {

/// All in `frame`, after a DELETEALL, by namespace:
///   candidates        line of each candidate, the chosen one green and thick
///   candidate_labels  its label and cost, at its middle
///   predictions       where the movers are expected for 3 s: a dot each 0.5 s, and the ellipse of two
///                     standard deviations where there is a covariance
///   velocity_cones    forbidden velocities, drawn from the robot at 1 m for 1 m/s
///   velocity_wanted   the best velocity outside them, likewise
/// What is not finite is left out: one such number and rviz2 refuses the whole array.
visualization_msgs::msg::MarkerArray to_markers(const PlanningProblem& problem, const PlanningResult& result,
                                                const std::string& frame);

}  // namespace bw
