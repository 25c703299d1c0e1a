// Made-up clusters for tests of the tracker: ten sweeps a second, positions without noise.
#pragma once

#include <cstdint>
#include <vector>

#include "components/people/tracker/cluster_track.hpp"

namespace bw::people {

constexpr double kSweepTime = 0.1;  // [s]

inline Sighting sighting(std::int64_t sweep, const Vector2& position, double leg_score = 0.9) {
  return {.sweep = sweep,
          .time = kSweepTime * static_cast<double>(sweep),
          .position = position,
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

/// Seen in sweeps `from` to `to` at position(time).
template <class Position>
ClusterTrack track_of(std::int64_t from, std::int64_t to, const Position& position, double leg_score = 0.9) {
  std::vector<Sighting> sightings;
  for (std::int64_t sweep = from; sweep <= to; ++sweep)
    sightings.push_back(sighting(sweep, position(kSweepTime * static_cast<double>(sweep)), leg_score));
  return track_of(sightings);
}

inline ClusterTrack standing(const Vector2& position, std::int64_t to, double leg_score = 0.9) {
  return track_of(
      to - 5, to, [&](double) { return position; }, leg_score);
}

}  // namespace bw::people
