#include "components/localization/laser/beam_ends.hpp"

namespace bw::localization {
namespace {

// Index of the beam in [first, last) nearest its middle that hit something; last when none.
std::size_t nearest_hit(const LaserSweep& sweep, std::size_t first, std::size_t last) {
  const auto hit = [&](std::size_t i) {
    const float range = sweep.ranges[i];
    return kind_of(range, sweep) == BeamKind::hit && range < sweep.range_max;
  };
  const std::size_t middle = first + (last - first) / 2;
  for (std::size_t step = 0; step <= last - first; ++step) {
    if (middle + step < last && hit(middle + step)) return middle + step;
    if (middle >= first + step && hit(middle - step)) return middle - step;
  }
  return last;
}

}  // namespace

BeamEnds beam_ends(const LaserSweep& sweep, int max_beams) {
  BeamEnds ends;
  if (max_beams <= 0) return ends;
  const std::size_t count = sweep.ranges.size();
  ends.scanner = sweep.X_FL.position();
  const auto parts = static_cast<std::size_t>(max_beams);
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t first = part * count / parts;
    const std::size_t last = (part + 1) * count / parts;
    if (first == last) continue;
    const std::size_t i = nearest_hit(sweep, first, last);
    if (i == last) continue;
    const double angle = sweep.angle_min + static_cast<double>(i) * sweep.angle_increment;
    const Vector2 end_B = scanner_at(sweep, i) * (static_cast<double>(sweep.ranges[i]) * direction(angle));
    ends.x.push_back(static_cast<float>(end_B.x()));
    ends.y.push_back(static_cast<float>(end_B.y()));
  }
  return ends;
}

}  // namespace bw::localization
