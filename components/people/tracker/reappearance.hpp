// Whether somebody who appears is somebody who was out of sight: as long as nobody walks faster than people
// do, who appears where somebody lost could have got to meanwhile is taken for them.
#pragma once

#include <optional>
#include <vector>

#include "components/people/tracker/person_track.hpp"
#include "components/people/tracker/tracker_options.hpp"

namespace bw::people {

/// How far `place` at `time` [s, from the tracker's own origin] is from where somebody seen last as `lost`
/// would be had they stayed, gone on, or turned back, in parts of what people deviate in that time; nothing
/// where they could not have got to.
std::optional<double> doubt_of_return(const PastState& lost, const Vector2& place, double time,
                                      const ReturnOptions& options);

/// Takes out whoever of `lost`, and of `people` not seen for sure at `now` [s], most likely is who was seen
/// first as `appeared`.
std::optional<PersonTrack> take_returned(std::vector<PersonTrack>& people, std::vector<PersonTrack>& lost,
                                         const Sighting& appeared, double now, const ReturnOptions& options);

}  // namespace bw::people
