#include "components/people/tracker/visibility.hpp"

#include <cmath>
#include <numbers>
#include <optional>

namespace bw::people {

namespace {

/// Range of the beam through `position` minus the distance of `position`; nothing out of view or of an
/// unusable beam.
std::optional<double> room_behind(const DetectionSet& sweep, const Vector2& position) {
  if (sweep.free_ranges.empty() || sweep.angle_increment == 0.0) return std::nullopt;
  const Vector2 to_position = position - sweep.sensor;
  // How far to rotate from the first beam, in the sense of the beams.
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  double angle = std::atan2(to_position.y(), to_position.x()) - sweep.angle_min;
  if (sweep.angle_increment < 0.0) angle = -angle;
  angle -= kTwoPi * std::floor(angle / kTwoPi);
  const double beam = angle / std::abs(sweep.angle_increment) + 0.5;  // rounded by what follows
  if (!(beam < static_cast<double>(sweep.free_ranges.size()))) return std::nullopt;
  const double range = static_cast<double>(sweep.free_ranges[static_cast<std::size_t>(beam)]);
  if (!(range > 0.0)) return std::nullopt;
  return range - to_position.norm();
}

}  // namespace

bool seen_empty(const DetectionSet& sweep, const Vector2& position, double margin) {
  const auto room = room_behind(sweep, position);
  return room && *room > margin;
}

}  // namespace bw::people
