#include "components/people/tracker/walking.hpp"

#include <algorithm>
#include <cmath>

namespace bw::people {
namespace {

constexpr double kStays = 0.1;             // [m] shorter distances are none
constexpr double kShareOfDistance = 0.25;  // share of the distance of both that each leg goes

/// Each of two legs, in what is seen of both.
bool both_moved(const CommonSightings& common, double distance) {
  const auto oldest = static_cast<std::size_t>(common.count - 1);
  const auto moved = [&](const auto& legs) {
    return (legs[0]->position - legs[oldest]->position).norm() > kShareOfDistance * distance;
  };
  return moved(common.a) && moved(common.b);
}

}  // namespace

int sightings_within(const ClusterTrack& cluster, double seconds) {
  int n = 1;
  while (n < cluster.remembered() && cluster.last().time - cluster.sighting(n).time <= seconds) ++n;
  return n;
}

std::optional<Walk> walk_of_pair(const ClusterTrack& a, const ClusterTrack& b, const BirthOptions& options) {
  if ((a.last().position - b.last().position).norm() > options.kSeparation) return std::nullopt;
  CommonSightings common(a, b);
  common.forget_before(common.time(0) - options.kLookBack);
  if (common.count < options.kFewest || common.time(0) - common.time(options.kFewest - 1) > options.kWithin ||
      common.time(0) - common.time(common.count - 1) < options.seen - kRounding)
    return std::nullopt;
  const auto leg_score = [](const Sighting& s) { return s.leg_score; };
  const double score = std::min(mean_of(a, sightings_within(a, options.kLookBack), leg_score),
                                mean_of(b, sightings_within(b, options.kLookBack), leg_score));
  if (score < options.kWalkingScore) return std::nullopt;
  const Gait gait = gait_of(common, common.count);
  if (gait.misfit > options.kMisfit || gait.widest > options.kSeparation) return std::nullopt;
  const int oldest = common.count - 1;
  const double distance = gait.velocity.norm() * (common.time(0) - common.time(oldest));
  if (distance < options.kTravel) return std::nullopt;
  if (!both_moved(common, distance)) return std::nullopt;
  return Walk{distance, gait.velocity.norm()};
}

bool stays(const ClusterTrack& a, const ClusterTrack& b, const BirthOptions& options) {
  const CommonSightings common(a, b);
  if (common.count < 2) return true;
  const double distance = (common.middle(0) - common.middle(common.count - 1)).norm();
  return distance < kStays || !both_moved(common, distance) ||
         gait_of(common, common.count).misfit > options.kMisfit;
}

std::optional<Walk> walk_of_single(const ClusterTrack& cluster, const BirthOptions& options) {
  const int n = sightings_within(cluster, options.kLookBack);
  const Sighting& now = cluster.last();
  const Sighting& oldest = cluster.sighting(n - 1);
  const double seconds = now.time - oldest.time;
  if (seconds < options.kSingleTime) return std::nullopt;
  const double distance = (now.position - oldest.position).norm();
  if (distance < options.kSingleTravel) return std::nullopt;
  const double on_static = mean_of(cluster, n, [](const Sighting& s) { return s.on_static ? 1.0 : 0.0; });
  const double score = mean_of(cluster, n, [](const Sighting& s) { return s.human_score(); });
  if (on_static > options.kSingleStatic || score < options.kSingleScore) return std::nullopt;
  // What slides along a wall behind somebody's shadow is cut off on a side; a leg alone stands free.
  const double cut = mean_of(cluster, n, [](const Sighting& s) { return s.occluded ? 1.0 : 0.0; });
  if (cut > options.kSingleCut) return std::nullopt;
  const auto share =
      static_cast<double>(now.nth - oldest.nth) / static_cast<double>(now.sweep - oldest.sweep);
  if (share < options.kSingleSeen) return std::nullopt;
  double path = 0.0;
  for (int k = 1; k < n; ++k) {
    const Sighting& after = cluster.sighting(k - 1);
    const Sighting& before = cluster.sighting(k);
    const double step = (after.position - before.position).norm();
    if (step > options.kSingleStep + options.kSingleSpeed * (after.time - before.time)) return std::nullopt;
    path += step;
  }
  if (distance < options.kSingleStraight * path) return std::nullopt;
  return Walk{distance, distance / seconds};
}

}  // namespace bw::people
