// How two clusters went along together: legs of one person stay close, and the middle between them goes
// straight.
#pragma once

#include <array>

#include "components/people/tracker/cluster_track.hpp"

namespace bw::people {

/// Sightings of two clusters in the sweeps that showed both, from the last back. Refers to the clusters.
struct CommonSightings {
  std::array<const Sighting*, ClusterTrack::kRemembered> a{};
  std::array<const Sighting*, ClusterTrack::kRemembered> b{};
  int count = 0;

  CommonSightings(const ClusterTrack& first, const ClusterTrack& second);
  void forget_before(double oldest);  ///< [s]
  Vector2 middle(int k) const;
  double separation(int k) const;  ///< [m]
  double time(int k) const { return a[static_cast<std::size_t>(k)]->time; }
};

struct Gait {
  double widest = 0.0;         ///< from leg to leg [m]
  double misfit = 0.0;         ///< of the middle to a straight path at one speed, root mean square [m]
  Vector2 velocity{0.0, 0.0};  ///< along that way [m/s]
  Vector2 start{0.0, 0.0};     ///< on that way, at `since`
  double since = 0.0;          ///< the first of the sightings [s]

  /// How little the two look like legs of one person [m].
  double doubt() const { return widest + 4.0 * misfit; }
};

/// Of the last `sightings` at most; at least one must be common.
Gait gait_of(const CommonSightings& common, int sightings);

}  // namespace bw::people
