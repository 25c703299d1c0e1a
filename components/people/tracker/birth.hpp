// When clusters are a person: two that walk or stand like legs, or one that walks like a leg with the other
// one hidden, seen nearly always and without leaps.
#pragma once

#include <optional>
#include <vector>

#include "components/people/tracker/cluster_track.hpp"
#include "components/people/tracker/tracker_options.hpp"

namespace bw::people {

enum class BirthKind { walking_pair, walking_single, standing_pair, standing_single };

struct Birth {
  BirthKind kind = BirthKind::walking_pair;
  double doubt = 0.0;     ///< ranks those that want the same leg: less first [m]
  double distance = 0.0;  ///< walked so far [m]

  bool stands() const { return kind != BirthKind::walking_pair && kind != BirthKind::walking_single; }
};

/// Clusters that are a person, by their index.
struct Candidate {
  int first = 0;
  int second = -1;  ///< -1: one leg, or both in one
  Birth birth;
};

/// Two clusters, both seen in the last sweep, as the legs of one person; nothing when they are not.
std::optional<Birth> birth_of_pair(const ClusterTrack& a, const ClusterTrack& b, const BirthOptions& options);

/// The same of one cluster alone.
std::optional<Birth> birth_of_single(const ClusterTrack& cluster, const BirthOptions& options);

/// Everybody among the clusters seen in sweep number `sweep`; no cluster twice, the least doubtful first.
void find_people(const std::vector<ClusterTrack>& clusters, std::int64_t sweep, const BirthOptions& options,
                 std::vector<Candidate>& found);

/// The filter of a candidate, from all its remembered sightings.
Walker walker_of(const ClusterTrack& first, const ClusterTrack* second, const WalkerOptions& options);

}  // namespace bw::people
