// Who is out of sight: where they may be, from sweep to sweep, and whether somebody who appears is one of
// them.
#pragma once

#include <optional>
#include <vector>

#include "components/model/random.hpp"
#include "components/people/tracker/person_track.hpp"
#include "components/people/tracker/seen_walls.hpp"
#include "components/people/tracker/tracker_options.hpp"

namespace bw::people {

/// What a sweep at `now` [s, from the tracker's own origin] shows of the room: `dt` [s] after the sweep
/// before of any sensor, `since_own` [s] after the one before of its own.
struct Surroundings {
  const DetectionSet& sweep;
  const SeenWalls& walls;
  double now;
  double dt;
  double since_own;
};

/// Follows where `person` may be as long as they are not seen for sure. Unless it is `known` where
/// they are, that is where they are tracked.
void follow_hidden(PersonTrack& person, const Surroundings& about, bool known, Random& random,
                   const TrackerOptions& options);

/// Takes out whoever hidden stood at `position` when seen last; nothing when nobody did.
std::optional<PersonTrack> take_who_stood(std::vector<PersonTrack>& people, std::vector<PersonTrack>& lost,
                                          const Vector2& position);

/// Takes out whoever hidden, of `people` and `lost`, most likely is who was seen first as `appeared` and goes
/// at `velocity`, if that is known; nothing when somebody new is more likely than each of them.
std::optional<PersonTrack> take_returned(std::vector<PersonTrack>& people, std::vector<PersonTrack>& lost,
                                         const Sighting& appeared, std::optional<Vector2> velocity,
                                         double now, const HiddenOptions& options);

}  // namespace bw::people
