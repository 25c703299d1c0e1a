// How much more than an obstacle a mover is, by its confidence: the one formula of all planners (book 7.10).
//
//   s(c) = min(1, c / kConfirmed)
//
// s scales what is kept from a mover beyond what the costmap shows of it: its extent, the comfortable distance and the spread
// of its prediction. Whether a motion is feasible asks the confirmed alone (s = 1). Everything here rises with c, so that more
// confidence never brings a plan nearer.
#pragma once

#include "components/model/obstacles.hpp"

namespace bw {

/// A confidence that is not from 0 to 1 says nothing, and a person is the safe guess: NaN and such count as confirmed.
inline bool is_confirmed(double confidence) { return !(confidence >= 0.0 && confidence < kConfirmed); }
inline bool is_confirmed(const Mover& mover) { return is_confirmed(mover.confidence); }

/// s(c): from 0, an obstacle and nothing more, to 1, a person.
inline double presence(double confidence) { return is_confirmed(confidence) ? 1.0 : confidence / kConfirmed; }
inline double presence(const Mover& mover) { return presence(mover.confidence); }

/// A disc of s(c) times the radius: what a possible person takes up in costs. At 0 that is a point.
inline double present_radius(const Mover& mover) { return presence(mover) * mover.radius; }

}  // namespace bw
