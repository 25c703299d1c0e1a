// What a band means in time: its velocity profile and the command at its start (theory.md 6.6).
#pragma once

#include <vector>

#include "components/local_planner/teb/band.hpp"
#include "components/model/planning.hpp"

namespace bw::teb {

/// Mean velocity of segment i: motion along the mean heading, rotation, both over dt.
Twist2 segment_velocity(const Band& band, std::size_t i);

/// Velocity `time` [s] after the start: segment velocities hold at the middles of their segments and are
/// linear between; `start` at 0.
Twist2 velocity_at(const Band& band, const Twist2& start, double time);

/// Poses of the band with times from now and velocities; the last one at rest if `goal_at_rest`.
std::vector<TrajectoryPoint> to_trajectory(const Band& band, const Twist2& start, bool goal_at_rest);

/// What the base makes of it in the first `duration` [s]: from the measured velocity on, in steps of the
/// control period, the velocities of the profile within the limits, which the band itself only pays for.
/// `hurried`: slowing down with stop_deceleration.
std::vector<TrajectoryPoint> as_driven(const Band& band, const PlanningProblem& problem, double duration,
                                       bool hurried);

}  // namespace bw::teb
