#include "components/evaluation/possible/search_scene.hpp"

#include <algorithm>

namespace bw::possible {

std::optional<Vector2> Walk::at(double time) const {
  constexpr double kRounding = 1e-9;  // [s]
  if (positions.empty() || time < positions.front().time - kRounding ||
      time > positions.back().time + kRounding)
    return std::nullopt;
  const auto later = [](double t, const TimedPosition& timed) { return t < timed.time; };
  const auto next = std::upper_bound(positions.begin(), positions.end(), time, later);
  if (next == positions.begin()) return positions.front().position;
  if (next == positions.end()) return positions.back().position;
  const TimedPosition& before = *(next - 1);
  return before.position +
         (time - before.time) / (next->time - before.time) * (next->position - before.position);
}

MotionBounds bounds_of(const Limits& limits, double factor) {
  MotionBounds bounds{limits.v_max, limits.v_back_max, limits.omega_max, factor * limits.acc_max,
                      factor * limits.alpha_max};
  if (factor > 1.0) bounds.acceleration = std::max(bounds.acceleration, limits.stop_deceleration);
  return bounds;
}

}  // namespace bw::possible
