// Made-up clusters for tests of the tracker: ten sweeps a second, places without noise.
#pragma once

#include <cstdint>
#include <vector>

#include "components/people/tracker/cluster_track.hpp"

namespace bw::people {

constexpr double kSweepTime = 0.1;  // [s]

inline Sighting sighting(std::int64_t sweep, const Vector2& place, double leg_score = 0.9) {
  return {.sweep = sweep,
          .time = kSweepTime * static_cast<double>(sweep),
          .position = place,
          .variance = 1e-4,
          .leg_score = leg_score};
}

inline ClusterTrack track_of(const std::vector<Sighting>& sightings) {
  ClusterTrack track(sightings.front());
  for (std::size_t k = 1; k < sightings.size(); ++k) {
    track.predict(sightings[k].time - sightings[k - 1].time);
    track.correct(sightings[k]);
  }
  return track;
}

/// Seen in sweeps `from` to `to` at place(time).
template <class Place>
ClusterTrack track_of(std::int64_t from, std::int64_t to, const Place& place, double leg_score = 0.9) {
  std::vector<Sighting> sightings;
  for (std::int64_t sweep = from; sweep <= to; ++sweep)
    sightings.push_back(sighting(sweep, place(kSweepTime * static_cast<double>(sweep)), leg_score));
  return track_of(sightings);
}

inline ClusterTrack standing(const Vector2& place, std::int64_t to, double leg_score = 0.9) {
  return track_of(
      to - 5, to, [&](double) { return place; }, leg_score);
}

}  // namespace bw::people
