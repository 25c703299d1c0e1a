// A limit of the speed that comes from outside, as Nav2's speed filter gives it, beside those of the base.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "components/model/limits.hpp"

namespace bw {

/// The fields of nav2_msgs/SpeedLimit.
struct SpeedLimit {
  bool percentage = false;  ///< of the base's own top speed
  double value = 0.0;       ///< [m/s], or 0 to 100; 0: no limit
};

/// Why it is none; empty: it is one.
inline std::string fault_of(const SpeedLimit& limit) {
  if (!std::isfinite(limit.value)) return "it is not finite";
  if (limit.value < 0.0) return "it is negative";
  if (limit.percentage && limit.value > 100.0) return "it is more than 100 %";
  return {};
}

/// The limits of the base under a limit without fault_of(): neither forward nor backward speed exceeds it;
/// rotating in place is no speed and stays. Nothing plans with less than 0.01 m/s, so that this is the
/// smallest limit.
inline Limits limited(Limits limits, const SpeedLimit& limit) {
  constexpr double kSmallest = 0.01;  // of `v_max` in limits.hpp
  if (limit.value == 0.0) return limits;
  const double speed = limit.percentage ? limit.value / 100.0 * limits.v_max : limit.value;
  const double most = std::max(speed, kSmallest);
  limits.v_max = std::min(limits.v_max, most);
  limits.v_back_max = std::min(limits.v_back_max, most);
  return limits;
}

}  // namespace bw
