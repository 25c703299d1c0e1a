#include "components/people/tracker/visibility.hpp"

#include <cmath>
#include <numbers>
#include <optional>

namespace bw::people {

namespace {

/// Range of the beam through `place` minus the distance of `place`; nothing out of view or of an unusable
/// beam.
std::optional<double> room_behind(const DetectionSet& sweep, const Vector2& place) {
  if (sweep.free_ranges.empty() || sweep.angle_increment == 0.0) return std::nullopt;
  const Vector2 to_place = place - sweep.sensor;
  // How far to turn from the first beam, in the sense of the beams.
  constexpr double kTurn = 2.0 * std::numbers::pi;
  double turn = std::atan2(to_place.y(), to_place.x()) - sweep.angle_min;
  if (sweep.angle_increment < 0.0) turn = -turn;
  turn -= kTurn * std::floor(turn / kTurn);
  const double beam = std::round(turn / std::abs(sweep.angle_increment));
  if (!(beam < static_cast<double>(sweep.free_ranges.size()))) return std::nullopt;
  const double range = static_cast<double>(sweep.free_ranges[static_cast<std::size_t>(beam)]);
  if (!(range > 0.0)) return std::nullopt;
  return range - to_place.norm();
}

}  // namespace

bool seen_empty(const DetectionSet& sweep, const Vector2& place, double margin) {
  const auto room = room_behind(sweep, place);
  return room && *room > margin;
}

}  // namespace bw::people
