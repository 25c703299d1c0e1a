#include "components/people/tracker/untangle.hpp"

#include <limits>

namespace bw::people {
namespace {

constexpr double kImpossible = std::numeric_limits<double>::infinity();

struct Leg {
  const ClusterTrack* track;
  bool stranger;
};

struct Pairing {
  std::size_t i = 0;
  std::size_t j = 0;
  double doubt = kImpossible;
};

/// How far the legs' way starts from where the person was going [m].
double miss_of(const PersonTrack& person, const LegPair& legs, const UntangleOptions& options) {
  const Gait gait = gait_of(*legs[0], *legs[1], options.sweeps);
  const Vector2 expected =
      person.settled.position + (gait.since - person.settled.time) * person.settled.velocity;
  return (gait.start - expected).norm();
}

}  // namespace

std::optional<double> doubt_of_legs(const ClusterTrack& a, const ClusterTrack& b,
                                    const UntangleOptions& options) {
  const Gait gait = gait_of(a, b, options.sweeps);
  if (gait.common < options.least) return std::nullopt;
  return gait.widest + 4.0 * gait.misfit;
}

std::vector<LegPair> better_pairs(const std::vector<const PersonTrack*>& people,
                                  const std::vector<const ClusterTrack*>& strangers, std::int64_t sweep,
                                  const UntangleOptions& options) {
  std::vector<Leg> legs;
  double now = -options.margin;
  for (const PersonTrack* person : people) {
    const auto& [first, second] = person->legs;
    for (const auto* leg : {&first, &second})
      if (*leg && (*leg)->last().sweep == sweep) legs.push_back({&**leg, false});
    const bool both = first && second && first->last().sweep == sweep && second->last().sweep == sweep;
    now += both ? doubt_of_legs(*first, *second, options).value_or(options.alone) : options.alone;
  }
  for (const ClusterTrack* stranger : strangers) legs.push_back({stranger, true});
  if (legs.size() < 2 * people.size()) return {};

  std::vector<Pairing> pairings;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    for (std::size_t j = i + 1; j < legs.size(); ++j) {
      const auto doubt = doubt_of_legs(*legs[i].track, *legs[j].track, options);
      if (!doubt || (legs[i].stranger && legs[j].stranger)) continue;
      const double strange = legs[i].stranger || legs[j].stranger ? options.stranger : 0.0;
      if (*doubt + strange < now) pairings.push_back({i, j, *doubt + strange});
    }
  }
  double least = now;
  std::vector<LegPair> best;
  const auto pair_of = [&](const Pairing& p) { return LegPair{legs[p.i].track, legs[p.j].track}; };
  for (const Pairing& first : pairings) {
    if (people.size() == 1) {
      if (first.doubt >= least) continue;
      least = first.doubt;
      best = {pair_of(first)};
      continue;
    }
    for (const Pairing& second : pairings) {
      if (&second <= &first || first.i == second.i || first.i == second.j || first.j == second.i ||
          first.j == second.j || first.doubt + second.doubt >= least)
        continue;
      least = first.doubt + second.doubt;
      best = {pair_of(first), pair_of(second)};
    }
  }
  if (best.size() == 2) {
    const double straight = miss_of(*people[0], best[0], options) + miss_of(*people[1], best[1], options);
    const double crossed = miss_of(*people[0], best[1], options) + miss_of(*people[1], best[0], options);
    if (crossed < straight) std::swap(best[0], best[1]);
  }
  return best;
}

}  // namespace bw::people
