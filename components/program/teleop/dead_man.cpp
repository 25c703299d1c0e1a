#include "components/program/teleop/dead_man.hpp"

#include <algorithm>

namespace bw {

void DeadMan::change_speed(int tenths) { tenths_ = std::clamp(tenths_ + tenths, 1, 10); }

Twist2 DeadMan::twist(Time now) const {
  if (!is_driving(now)) return {};
  // Backwards the robot sees nothing: at half the speed.
  const double forward = direction_.forward < 0 ? -0.5 : direction_.forward;
  return {forward * share() * options_.v, direction_.rotation * share() * options_.omega};
}

}  // namespace bw
