#include "components/people/tracker/person_track.hpp"

namespace bw::people {
namespace {

constexpr double kStep = 0.45;   // [m] no leg does more from one sweep to the next
constexpr double kPause = 0.35;  // [s] after which it may be anywhere

}  // namespace

void PersonTrack::remember_leg(std::size_t leg, const Sighting& seen) {
  std::optional<ClusterTrack>& track = legs[leg];
  const bool same = track && seen.time - track->last().time <= kPause &&
                    (track->last().position - seen.position).norm() < kStep;
  if (same) {
    track->correct(seen);
  } else {
    track.emplace(seen);
  }
}

}  // namespace bw::people
