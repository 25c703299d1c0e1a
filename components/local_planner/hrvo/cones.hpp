// The velocities that lead to a contact with one neighbour (theory.md 5.3).
#pragma once

#include "components/local_planner/hrvo/neighbours.hpp"
#include "components/model/planning.hpp"

namespace bw::hrvo {

/// What the robot is and wants at this moment. [m], [m/s], planning frame.
struct RobotMotion {
  Vector2 position{0.0, 0.0};
  Vector2 velocity{0.0, 0.0};
  Vector2 preferred{0.0, 0.0};
  double heading = 0.0;  ///< [rad]; tells where an obstacle "is" whose core lies under the robot's centre
};

/// Velocity obstacle (apex at the neighbour's velocity) of a neighbour that leaves the avoiding to the robot;
/// hybrid reciprocal one of a neighbour that shares it: the reciprocal leg (apex of both lines half way
/// between the velocities) on the side on which they pass, the other leg of the velocity obstacle. Within
/// `radius` the velocities of a half plane (legs opposite to each other): those that do not end the overlap
/// within time_step, half of it when shared.
VelocityCone cone_of(const Neighbour& neighbour, const RobotMotion& robot, const HrvoOptions& options);

/// Strictly inside by more than `tolerance` [m/s] from both legs: det(right, v - apex) > 0 and
/// det(left, v - apex) < 0.
inline bool is_inside(const VelocityCone& cone, const Vector2& v, double tolerance) {
  return cross(cone.right, v - cone.apex) > tolerance && cross(cone.left, v - cone.apex) < -tolerance;
}

}  // namespace bw::hrvo
