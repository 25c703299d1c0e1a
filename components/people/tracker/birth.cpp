#include "components/people/tracker/birth.hpp"

#include <algorithm>

#include "components/people/tracker/gait.hpp"
#include "components/people/tracker/walking.hpp"

namespace bw::people {
namespace {

double share_on_static(const ClusterTrack& cluster) {
  return mean_of(cluster, cluster.remembered(), [](const Sighting& s) { return s.on_static ? 1.0 : 0.0; });
}

double leg_share(const ClusterTrack& cluster) {
  return mean_of(cluster, cluster.remembered(), [](const Sighting& s) { return s.leg_score; });
}

/// Two that stand about as the legs of somebody do.
std::optional<Birth> birth_of_standing_pair(const ClusterTrack& a, const ClusterTrack& b,
                                            const BirthOptions& options) {
  if ((a.last().position - b.last().position).norm() > options.kStandingSeparation) return std::nullopt;
  const CommonSightings common(a, b);
  if (common.count < options.kFewest) return std::nullopt;
  const double stood = common.time(0) - common.time(common.count - 1);
  const double score = std::min(leg_share(a), leg_share(b));
  if (stood < options.kStandingTime - kRounding || score < options.kStandingScore) return std::nullopt;
  const bool on_background = std::max(share_on_static(a), share_on_static(b)) >= 0.5;
  if (on_background && (score < options.kBackgroundScore || stood < options.kBackgroundTime - kRounding))
    return std::nullopt;
  return Birth{BirthKind::standing_pair, gait_of(common, common.count).doubt() - 0.5 * score, 0.0};
}

}  // namespace

std::optional<Birth> birth_of_pair(const ClusterTrack& a, const ClusterTrack& b,
                                   const BirthOptions& options) {
  if ((a.last().position - b.last().position).norm() > options.kSeparation) return std::nullopt;
  if (const auto walk = walk_of_pair(a, b, options)) {
    const double score = std::min(leg_share(a), leg_share(b));
    return Birth{BirthKind::walking_pair,
                 gait_of(CommonSightings(a, b), ClusterTrack::kRemembered).doubt() - 0.5 * score,
                 walk->distance};
  }
  return birth_of_standing_pair(a, b, options);
}

std::optional<Birth> birth_of_single(const ClusterTrack& cluster, const BirthOptions& options) {
  const double score =
      mean_of(cluster, cluster.remembered(), [](const Sighting& s) { return s.human_score(); });
  if (const auto walk = walk_of_single(cluster, options))
    return Birth{BirthKind::walking_single, 1.0 - score, walk->distance};
  if (cluster.id != 0 && cluster.existence.log_odds() >= 0.0)
    return Birth{BirthKind::standing_single, 1.0 - score, 0.0};
  return std::nullopt;
}

void find_people(const std::vector<ClusterTrack>& clusters, std::int64_t sweep, const BirthOptions& options,
                 std::vector<Candidate>& found) {
  found.clear();
  const auto seen = [&](std::size_t i) { return clusters[i].last().sweep == sweep; };
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    if (!seen(i)) continue;
    for (std::size_t j = i + 1; j < clusters.size(); ++j) {
      if (!seen(j)) continue;
      if (const auto birth = birth_of_pair(clusters[i], clusters[j], options))
        found.push_back({static_cast<int>(i), static_cast<int>(j), *birth});
    }
    if (const auto birth = birth_of_single(clusters[i], options))
      found.push_back({static_cast<int>(i), -1, *birth});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Candidate& a, const Candidate& b) { return a.birth.doubt < b.birth.doubt; });
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
