#include "components/people/tracker/leg_reassociation.hpp"

#include <algorithm>
#include <utility>

#include "components/people/tracker/gait.hpp"

namespace bw::people {
namespace {

constexpr int kNobody = -1;

struct Leg {
  const ClusterTrack* track;
  int cluster;  ///< index of what was nobody's; kNobody for a leg of these people
};

struct Pairing {
  std::size_t i;
  std::size_t j;
  double doubt;
};

bool overlap(const Pairing& a, const Pairing& b) {
  return a.i == b.i || a.i == b.j || a.j == b.i || a.j == b.j;
}

/// Theirs and what stands near and looks like a leg, as far as this sweep showed it.
std::vector<Leg> legs_about(const std::vector<const PersonTrack*>& people,
                            const std::vector<ClusterTrack>& clusters, std::int64_t sweep,
                            const LegReassociationOptions& options) {
  std::vector<Leg> legs;
  for (const PersonTrack* person : people)
    for (const auto& leg : person->legs)
      if (leg && leg->last().sweep == sweep) legs.push_back({&*leg, kNobody});
  int room = options.kUnrelatedClusters;
  for (std::size_t i = 0; i < clusters.size() && room > 0; ++i) {
    const Sighting& last = clusters[i].last();
    if (last.sweep != sweep || last.leg_score < options.kScore) continue;
    const auto near = [&](const PersonTrack* person) {
      return (last.position - person->walker.position()).norm() <= options.kSeparation;
    };
    if (std::ranges::none_of(people, near)) continue;
    legs.push_back({&clusters[i], static_cast<int>(i)});
    --room;
  }
  return legs;
}

/// Doubt of the legs as they are paired.
double doubt_now(const PersonTrack& person, std::int64_t sweep, const LegReassociationOptions& options) {
  if (!person.both_legs_seen(sweep)) return options.kAlone;
  return doubt_of_legs(*person.legs[0], *person.legs[1], options).value_or(options.kAlone);
}

/// The least doubtful choice of one pair for each of `count` people, if less doubtful than `least`.
std::vector<Pairing> best_of(const std::vector<Pairing>& pairings, std::size_t count, double least) {
  std::vector<Pairing> best;
  for (std::size_t k = 0; k < pairings.size(); ++k) {
    const Pairing& first = pairings[k];
    if (count == 1 && first.doubt < least) {
      least = first.doubt;
      best = {first};
    }
    for (std::size_t l = k + 1; count == 2 && l < pairings.size(); ++l) {
      const Pairing& second = pairings[l];
      if (overlap(first, second) || first.doubt + second.doubt >= least) continue;
      least = first.doubt + second.doubt;
      best = {first, second};
    }
  }
  return best;
}

/// How far the legs' path starts from where the person was going when they were last sure to be theirs [m].
double miss_of(const PersonTrack& person, const Leg& a, const Leg& b,
               const LegReassociationOptions& options) {
  const Gait gait = gait_of(CommonSightings(*a.track, *b.track), options.kSightings);
  const PastState& before = person.settled;
  return (gait.start - before.position - (gait.since - before.time) * before.velocity).norm();
}

}  // namespace

std::optional<double> doubt_of_legs(const ClusterTrack& a, const ClusterTrack& b,
                                    const LegReassociationOptions& options) {
  const CommonSightings common(a, b);
  if (common.count < options.kLeast) return std::nullopt;
  return gait_of(common, options.kSightings).doubt();
}

std::optional<ReassociatedLegs> reassociate_legs(const std::vector<const PersonTrack*>& people,
                                                 const std::vector<ClusterTrack>& clusters,
                                                 std::int64_t sweep, const LegReassociationOptions& options) {
  const std::vector<Leg> legs = legs_about(people, clusters, sweep, options);
  if (legs.size() < 2 * people.size()) return std::nullopt;
  double now = -options.margin;
  for (const PersonTrack* person : people) now += doubt_now(*person, sweep, options);

  std::vector<Pairing> pairings;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    for (std::size_t j = i + 1; j < legs.size(); ++j) {
      if (legs[i].cluster != kNobody && legs[j].cluster != kNobody) continue;
      const auto doubt = doubt_of_legs(*legs[i].track, *legs[j].track, options);
      if (doubt && *doubt < now) pairings.push_back({i, j, *doubt});
    }
  }
  std::vector<Pairing> best = best_of(pairings, people.size(), now);
  if (best.empty()) return std::nullopt;
  if (best.size() == 2) {
    const auto miss = [&](std::size_t person, std::size_t pair) {
      return miss_of(*people[person], legs[best[pair].i], legs[best[pair].j], options);
    };
    if (miss(0, 1) + miss(1, 0) < miss(0, 0) + miss(1, 1)) std::swap(best[0], best[1]);
  }

  ReassociatedLegs result;
  for (const Pairing& pairing : best) result.legs.push_back({*legs[pairing.i].track, *legs[pairing.j].track});
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const bool chosen = std::ranges::any_of(best, [&](const Pairing& p) { return p.i == i || p.j == i; });
    if (chosen && legs[i].cluster != kNobody) result.taken.push_back(legs[i].cluster);
    if (!chosen && legs[i].cluster == kNobody) result.left.push_back(*legs[i].track);
  }
  return result;
}

}  // namespace bw::people
