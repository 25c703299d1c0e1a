#include "components/safety/empty_sight.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bw::safety {
namespace {

// From one sweep to the next (0.1 s, of slow lasers 0.2 s) a thing that is met at 3 m/s gets no farther away than this,
constexpr double kFarther = 1.0;  // [m]
// and at half a metre, walking aside past a robot that turns, no farther round.
constexpr double kRound = 0.3;  // [rad]
// So many points are a wall, a pillar, or a person nearer than 4 m (two legs of 0.14 m, beams 0.4 degrees apart). Who is
// farther away may be hidden by a leg, or missed.
constexpr std::size_t kCannotVanish = 10;

/// Points that a sound laser sees in its next sweep too, wherever they move.
std::size_t count_lasting(const LaserSweep& sweep, const CheckedSweep& checked) {
  const double width = static_cast<double>(sweep.ranges.size() - 1) * sweep.angle_increment;
  const double middle = sweep.angle_min + width / 2.0;
  const bool has_edges = std::abs(width) < 2.0 * std::numbers::pi - kRound;
  const Pose2 X_LF = inverse(sweep.X_FL);
  const auto lasts = [&](const SeenPoint& point) {
    const Vector2 p_L = X_LF * point.position;
    const double aside = std::abs(wrap_angle(std::atan2(p_L.y(), p_L.x()) - middle));
    return p_L.norm() < sweep.range_max - kFarther && (!has_edges || aside < std::abs(width) / 2.0 - kRound);
  };
  return static_cast<std::size_t>(std::count_if(checked.points.begin(), checked.points.end(), lasts));
}

}  // namespace

bool EmptySight::believes(const LaserSweep& sweep, const CheckedSweep& checked) {
  const bool is_empty = std::count(checked.beams.begin(), checked.beams.end(), BeamKind::hit) < min_returns_;
  if (is_empty && lasting_ >= kCannotVanish) return false;
  lasting_ = count_lasting(sweep, checked);
  has_seen_ = has_seen_ || !checked.points.empty();
  return true;
}

}  // namespace bw::safety
