#include "components/people/tracker/birth.hpp"

#include <algorithm>

#include "components/people/tracker/gait.hpp"

namespace bw::people {
namespace {

template <class Score>
double mean_score(const ClusterTrack& cluster, int count, const Score& score) {
  double sum = 0.0;
  const int n = std::min(count, cluster.remembered());
  for (int k = 0; k < n; ++k) sum += score(cluster.sighting(k));
  return sum / n;
}

double static_share(const ClusterTrack& cluster) {
  return mean_score(cluster, ClusterTrack::kRemembered,
                    [](const Sighting& s) { return s.on_static ? 1.0 : 0.0; });
}

double leg_share(const ClusterTrack& cluster) {
  return mean_score(cluster, ClusterTrack::kRemembered, [](const Sighting& s) { return s.leg_score; });
}

}  // namespace

std::optional<double> doubt_of_pair(const ClusterTrack& a, const ClusterTrack& b,
                                    const BirthOptions& options) {
  if ((a.last().position - b.last().position).norm() > options.separation) return std::nullopt;
  const double score = std::min(leg_share(a), leg_share(b));
  if (score < std::min(options.walking_score, options.standing_score)) return std::nullopt;
  const CommonSightings common(a, b);
  if (common.count < options.sightings) return std::nullopt;
  if (common.a[0]->sweep - common.a[static_cast<std::size_t>(options.sightings) - 1]->sweep >=
      options.of_sweeps)
    return std::nullopt;

  const Gait gait = gait_of(common, ClusterTrack::kRemembered);
  const int oldest = common.count - 1;
  const double travel = gait.velocity.norm() * (common.time(0) - common.time(oldest));
  if (gait.misfit > options.misfit || gait.widest > options.separation) return std::nullopt;
  const double doubt = gait.doubt() - 0.5 * score;

  const auto moved = [&](const auto& legs) {
    return (legs[0]->position - legs[static_cast<std::size_t>(oldest)]->position).norm() > 0.25 * travel;
  };
  if (travel >= options.travel && score >= options.walking_score && moved(common.a) && moved(common.b))
    return doubt;

  const bool stands = common.count >= options.standing_sightings && score >= options.standing_score &&
                      gait.widest <= options.kStandingSeparation;
  const bool on_background = std::max(static_share(a), static_share(b)) >= 0.5;
  if (stands && on_background &&
      (score < options.kBackgroundScore || common.count < options.kBackgroundSightings))
    return std::nullopt;
  if (stands) return doubt + 0.2;
  return std::nullopt;
}

std::optional<double> doubt_of_single(const ClusterTrack& cluster, const BirthOptions& options) {
  const int n = cluster.remembered();
  if (n < options.kSingleSightings) return std::nullopt;
  const Sighting& oldest = cluster.sighting(n - 1);
  const double travel = (cluster.last().position - oldest.position).norm();
  if (travel < options.kSingleTravel || static_share(cluster) > 0.3) return std::nullopt;
  const double score = mean_score(cluster, n, [](const Sighting& s) { return s.human_score(); });
  if (score < options.kSingleScore) return std::nullopt;
  // What slides along a wall behind somebody's shadow is cut off on a side; a leg alone stands free.
  const double cut = mean_score(cluster, n, [](const Sighting& seen) { return seen.occluded ? 1.0 : 0.0; });
  if (cut > options.kSingleCut) return std::nullopt;
  if (cluster.last().sweep - cluster.sighting(options.kSingleSightings - 1).sweep >= options.kSingleOfSweeps)
    return std::nullopt;
  double path = 0.0;
  for (int k = 1; k < n; ++k) {
    const double step = (cluster.sighting(k).position - cluster.sighting(k - 1).position).norm();
    if (step > options.single_step) return std::nullopt;
    path += step;
  }
  if (travel < options.kSingleStraight * path) return std::nullopt;
  return 1.0 - score;
}

void find_people(const std::vector<ClusterTrack>& clusters, std::int64_t sweep, const BirthOptions& options,
                 std::vector<Candidate>& found) {
  found.clear();
  const auto seen = [&](std::size_t i) { return clusters[i].last().sweep == sweep; };
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    if (!seen(i)) continue;
    for (std::size_t j = i + 1; j < clusters.size(); ++j) {
      if (!seen(j)) continue;
      if (const auto doubt = doubt_of_pair(clusters[i], clusters[j], options))
        found.push_back({static_cast<int>(i), static_cast<int>(j), *doubt});
    }
    if (const auto doubt = doubt_of_single(clusters[i], options))
      found.push_back({static_cast<int>(i), -1, 100.0 + *doubt});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Candidate& a, const Candidate& b) { return a.doubt < b.doubt; });
  std::vector<char> taken(clusters.size(), 0);
  std::erase_if(found, [&](const Candidate& candidate) {
    char& first = taken[static_cast<std::size_t>(candidate.first)];
    char none = 0;
    char& second = candidate.second < 0 ? none : taken[static_cast<std::size_t>(candidate.second)];
    if (first != 0 || second != 0) return true;
    first = second = 1;
    return false;
  });
}

Walker walker_of(const ClusterTrack& first, const ClusterTrack* second, const WalkerOptions& options) {
  constexpr double kWalkingVariance = 1.0;  // [m^2/s^2] of somebody new
  if (second == nullptr) {
    const int oldest = first.remembered() - 1;
    const Sighting& start = first.sighting(oldest);
    const bool whole = start.body_score > start.leg_score;
    Walker walker(options, whole ? BodyPart::middle : BodyPart::first_leg, start.position, {0.0, 0.0},
                  start.variance, kWalkingVariance);
    for (int k = oldest - 1; k >= 0; --k) {
      const Sighting& s = first.sighting(k);
      walker.predict(s.time - first.sighting(k + 1).time, options);
      walker.correct(s.body_score > s.leg_score ? BodyPart::middle : BodyPart::first_leg, s.position,
                     s.variance * Eigen::Matrix2d::Identity(), options);
    }
    return walker;
  }
  const CommonSightings common(first, *second);
  const int oldest = common.count - 1;
  const auto at = [&](int k) { return static_cast<std::size_t>(k); };
  Walker walker(common.a[at(oldest)]->position, common.b[at(oldest)]->position, {0.0, 0.0},
                common.a[at(oldest)]->variance, kWalkingVariance);
  for (int k = oldest - 1; k >= 0; --k) {
    walker.predict(common.time(k) - common.time(k + 1), options);
    for (const auto& [part, legs] :
         {std::pair{BodyPart::first_leg, &common.a}, std::pair{BodyPart::second_leg, &common.b}}) {
      const Sighting& s = *(*legs)[at(k)];
      walker.correct(part, s.position, s.variance * Eigen::Matrix2d::Identity(), options);
    }
  }
  return walker;
}

}  // namespace bw::people
