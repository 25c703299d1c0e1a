// Did the robot pass behind a person who crosses its path, or in front? Asked at the moment at which the
// robot crosses the person's line (protocols.md 8.5).
#pragma once

#include <string_view>
#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw {

struct TimedPosition {
  double time = 0.0;  ///< [s]
  Vector2 position{0.0, 0.0};
};

/// A person who walks on one line with constant velocity from time 0. The velocity must not be zero.
struct StraightWalk {
  Vector2 start{0.0, 0.0};
  Vector2 velocity{0.0, 1.0};
};

enum class Passing {
  behind,       ///< the person had already passed the position where the robot crossed the line
  in_front,     ///< the person came by there later
  not_crossed,  ///< the robot stayed on its side
};

std::string_view name_of(Passing passing);

/// `path` rises in time; between its positions the robot moves straight. A robot that crosses the line
/// several times is judged by the last crossing, which is how it got past; one that returned to its side has
/// not crossed.
Passing passing(const std::vector<TimedPosition>& path, const StraightWalk& person);

}  // namespace bw
