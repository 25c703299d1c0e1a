#include "components/people/tracker/gait.hpp"

#include <algorithm>
#include <cmath>

namespace bw::people {

CommonSightings::CommonSightings(const ClusterTrack& first, const ClusterTrack& second) {
  int i = 0;
  int j = 0;
  while (i < first.remembered() && j < second.remembered()) {
    const Sighting& x = first.sighting(i);
    const Sighting& y = second.sighting(j);
    if (x.sweep == y.sweep) {
      a[static_cast<std::size_t>(count)] = &x;
      b[static_cast<std::size_t>(count)] = &y;
      ++count;
    }
    i += x.sweep >= y.sweep ? 1 : 0;
    j += y.sweep >= x.sweep ? 1 : 0;
  }
}

void CommonSightings::forget_before(double oldest) {
  while (count > 0 && time(count - 1) < oldest) --count;
}

Vector2 CommonSightings::middle(int k) const {
  const auto i = static_cast<std::size_t>(k);
  return (a[i]->position + b[i]->position) / 2.0;
}

double CommonSightings::separation(int k) const {
  const auto i = static_cast<std::size_t>(k);
  return (a[i]->position - b[i]->position).norm();
}

Gait gait_of(const CommonSightings& common, int sightings) {
  const int n = std::min(common.count, sightings);
  Gait gait;
  Vector2 mean(0.0, 0.0);
  double mean_time = 0.0;
  for (int k = 0; k < n; ++k) {
    gait.widest = std::max(gait.widest, common.separation(k));
    mean += common.middle(k) / n;
    mean_time += common.time(k) / n;
  }
  Vector2 slope(0.0, 0.0);
  double spread = 0.0;
  for (int k = 0; k < n; ++k) {
    const double t = common.time(k) - mean_time;
    slope += t * (common.middle(k) - mean);
    spread += t * t;
  }
  if (spread > 0.0) gait.velocity = slope / spread;
  double square = 0.0;
  for (int k = 0; k < n; ++k)
    square += (common.middle(k) - mean - (common.time(k) - mean_time) * gait.velocity).squaredNorm();
  gait.misfit = std::sqrt(square / n);
  gait.since = common.time(n - 1);
  gait.start = mean + (gait.since - mean_time) * gait.velocity;
  return gait;
}

}  // namespace bw::people
