#include "components/local_planner/dwa/arc.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "components/model/differential_drive.hpp"
#include "components/model/mover_weight.hpp"

namespace bw::dwa {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kShortestMarch = 0.005;  // [m] so that a march along a wall ends
constexpr int kMaxMarches = 1000;         // what goes on longer is not known to be free

}  // namespace

Pose2 Arc::at(double time) const { return advance_exact(start, twist, time); }

// A gap of c cannot close within c metres of travel, so both searches may skip that far.

double contact_distance(const Arc& arc, const ClearanceField& field, double margin, double up_to) {
  const double speed = std::abs(arc.twist.v);
  if (speed == 0.0) return kNever;
  // What one whole circle does not meet, no second one does.
  up_to = std::min(up_to, 2.0 * std::numbers::pi * speed / std::abs(arc.twist.omega));
  double travel = 0.0;
  double left = field.at(arc.start.position()) - margin;
  if (left <= 0.0) return 0.0;
  for (int marches = 0; travel < up_to; ++marches) {
    if (marches == kMaxMarches) return travel;
    const double step = std::min(std::max(left, kShortestMarch), up_to - travel);
    const double left_after = field.at(arc.at((travel + step) / speed).position()) - margin;
    if (left_after <= 0.0) return travel + step * left / (left - left_after);
    travel += step;
    left = left_after;
  }
  return kNever;
}

double smallest_gap(const Arc& arc, const ClearanceField& field, double horizon, double step) {
  const double speed = std::abs(arc.twist.v);
  double smallest = field.at(arc.start.position());
  if (speed == 0.0 || std::isinf(smallest)) return smallest;
  double gap = smallest;
  for (double time = 0.0; time < horizon;) {
    time = std::min(horizon, time + std::max((gap - smallest) / speed, step));
    gap = field.at(arc.at(time).position());
    smallest = std::min(smallest, gap);
  }
  return smallest;
}

double smallest_gap(const Arc& arc, const std::vector<Mover>& movers, double robot_radius, double horizon,
                    double step) {
  double smallest = kNever;
  const int steps = static_cast<int>(std::ceil(horizon / step));
  for (int i = 0; i <= steps; ++i) {
    const double time = std::min(i * step, horizon);
    const Vector2 p = arc.at(time).position();
    for (const Mover& m : movers)
      smallest = std::min(smallest, (m.position_at(time) - p).norm() - present_radius(m) - robot_radius);
  }
  return smallest;
}

}  // namespace bw::dwa
