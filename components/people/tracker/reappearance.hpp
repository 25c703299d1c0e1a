// Who is out of sight: where they may be, from sweep to sweep, and whether somebody who appears is one of them.
#pragma once

#include <optional>
#include <vector>

#include "components/model/random.hpp"
#include "components/people/tracker/person_track.hpp"
#include "components/people/tracker/seen_walls.hpp"
#include "components/people/tracker/tracker_options.hpp"

namespace bw::people {

/// What a sweep at `now` [s, from the tracker's own origin], `dt` [s] after the one before, shows of the room.
struct Surroundings {
  const DetectionSet& sweep;
  const SeenWalls& walls;
  double now;
  double dt;
};

/// Follows where `person` may be as long as they are not seen for sure. Nothing of them seen at all: that is
/// where they are tracked from then on.
void follow_hidden(PersonTrack& person, const Surroundings& about, bool seen, Random& random,
                   const TrackerOptions& options);

/// Takes out whoever hidden, of `people` and `lost`, most likely is who was seen first as `appeared` and goes
/// at `velocity`; nothing when somebody new is more likely than each of them.
std::optional<PersonTrack> take_returned(std::vector<PersonTrack>& people, std::vector<PersonTrack>& lost,
                                         const Sighting& appeared, const Vector2& velocity, double now,
                                         const HiddenOptions& options);

}  // namespace bw::people
