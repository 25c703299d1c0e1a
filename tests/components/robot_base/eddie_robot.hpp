// Eddie with its quadrature board: 144 positions to a revolution of 2 pi 0.0762 m, 3.3249 mm each.
#pragma once

#include "components/model/robot.hpp"

namespace bw {

inline Robot eddie_robot() {
  Robot robot;
  robot.wheel_radius = 0.0762;
  robot.ticks_per_revolution = 144;
  robot.wheel_speed_max = 1.0;
  return robot;
}

}  // namespace bw
