#include "components/people/tracker/visibility.hpp"

#include <cmath>
#include <numbers>

namespace bw::people {

bool seen_empty(const DetectionSet& sweep, const Vector2& place, double margin) {
  if (sweep.free_ranges.empty() || sweep.angle_increment == 0.0) return false;
  const Vector2 to_place = place - sweep.sensor;
  const double range = to_place.norm();
  // How far to turn from the first beam, in the sense of the beams.
  constexpr double kTurn = 2.0 * std::numbers::pi;
  double turn = std::atan2(to_place.y(), to_place.x()) - sweep.angle_min;
  if (sweep.angle_increment < 0.0) turn = -turn;
  turn -= kTurn * std::floor(turn / kTurn);
  const double beam = std::round(turn / std::abs(sweep.angle_increment));
  if (!(beam < static_cast<double>(sweep.free_ranges.size()))) return false;
  return static_cast<double>(sweep.free_ranges[static_cast<std::size_t>(beam)]) > range + margin;
}

}  // namespace bw::people
