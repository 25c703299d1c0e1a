#include "components/localization/laser/beam_ends.hpp"

#include <cmath>

namespace bw::localization {
namespace {

// Index of the beam in [first, last) nearest its middle that returned something; last when none.
std::size_t nearest_return(const LaserReading& reading, std::size_t first, std::size_t last) {
  const auto returned = [&](std::size_t i) {
    const double range = static_cast<double>(reading.ranges[i]);
    return range >= reading.range_min && range < reading.range_max && std::isfinite(range);
  };
  const std::size_t middle = first + (last - first) / 2;
  for (std::size_t step = 0; step <= last - first; ++step) {
    if (middle + step < last && returned(middle + step)) return middle + step;
    if (middle >= first + step && returned(middle - step)) return middle - step;
  }
  return last;
}

}  // namespace

BeamEnds beam_ends(const LaserReading& reading, int max_beams) {
  BeamEnds ends;
  const std::size_t count = reading.ranges.size();
  if (max_beams <= 0 || count == 0 || !is_finite(reading.X_BL)) return ends;
  if (!std::isfinite(reading.angle_min) || !std::isfinite(reading.angle_increment)) return ends;
  ends.scanner = reading.X_BL.position();
  const auto parts = static_cast<std::size_t>(max_beams);
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t first = part * count / parts;
    const std::size_t last = (part + 1) * count / parts;
    if (first == last) continue;
    const std::size_t i = nearest_return(reading, first, last);
    if (i == last) continue;
    const double angle = reading.angle_min + static_cast<double>(i) * reading.angle_increment;
    const Vector2 end_B = reading.X_BL * (static_cast<double>(reading.ranges[i]) * direction(angle));
    ends.x.push_back(static_cast<float>(end_B.x()));
    ends.y.push_back(static_cast<float>(end_B.y()));
  }
  return ends;
}

}  // namespace bw::localization
