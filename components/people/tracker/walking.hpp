// Whether legs go as a walker's do: two that stay close while their middle goes straight, or one that goes on
// without leaps, free of what it might be the edge of.
#pragma once

#include <optional>

#include "components/people/tracker/cluster_track.hpp"
#include "components/people/tracker/gait.hpp"
#include "components/people/tracker/tracker_options.hpp"

namespace bw::people {

inline constexpr double kRounding = 1e-6;  ///< [s] by which times that are compared err

/// The distance of a walker in what is remembered of their legs.
struct Walk {
  double distance = 0.0;  ///< [m]
  double speed = 0.0;     ///< along it [m/s]
};

/// Of what is remembered of a thing, so many sightings are `seconds` old at most.
int sightings_within(const ClusterTrack& cluster, double seconds);

/// Mean over the last `count` sightings.
template <class Value>
double mean_of(const ClusterTrack& cluster, int count, const Value& value) {
  double sum = 0.0;
  for (int k = 0; k < count; ++k) sum += value(cluster.sighting(k));
  return sum / count;
}

std::optional<Walk> walk_of_pair(const ClusterTrack& a, const ClusterTrack& b, const BirthOptions& options);
/// Whether two that may be legs have gone nowhere in what is remembered of them, as far as their middle tells
/// and both feet agree.
bool stays(const ClusterTrack& a, const ClusterTrack& b, const BirthOptions& options);
std::optional<Walk> walk_of_single(const ClusterTrack& cluster, const BirthOptions& options);

}  // namespace bw::people
