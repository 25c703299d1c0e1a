// The point of the plan that the robot aims at.
#pragma once

#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw {

/// The point `distance` [m] along `plan` from where it is nearest to `robot`; its end if that is nearer, or
/// when `distance` is 0. `plan` is not empty.
Vector2 carrot(const std::vector<Pose2>& plan, const Vector2& robot, double distance);

}  // namespace bw
