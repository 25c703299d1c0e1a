// How much more than an obstacle a mover is, by its confidence: the one formula of all planners
// (local_planner/theory.md 7.10).
//
//   s(c) = min(1, max(0, c - kFurniture) / (kConfirmed - kFurniture))
//
// s scales what is kept from a mover beyond what the costmap shows of it: its extent, the comfortable
// distance and the spread of its prediction. Whether a motion is feasible asks the confirmed alone (s = 1).
// Everything here rises with c, so that more confidence never brings a plan nearer.
#pragma once

#include <algorithm>

#include "components/model/obstacles.hpp"

namespace bw {

/// Up to this confidence a mover is an obstacle and nothing more: two of three and more of them are
/// furniture.
inline constexpr double kFurniture = 0.3;

/// A confidence that is not from 0 to 1 says nothing, and a person is the safe guess: NaN and such count as
/// confirmed.
inline bool is_confirmed(double confidence) { return !(confidence >= 0.0 && confidence < kConfirmed); }
inline bool is_confirmed(const Mover& mover) { return is_confirmed(mover.confidence); }

/// s(c): from 0, an obstacle and nothing more, to 1, a person.
inline double presence(double confidence) {
  if (is_confirmed(confidence)) return 1.0;
  return std::max(0.0, confidence - kFurniture) / (kConfirmed - kFurniture);
}
inline double presence(const Mover& mover) { return presence(mover.confidence); }

/// A disc of s(c) times the radius: what a possible person takes up in costs. At 0 that is a point.
inline double present_radius(const Mover& mover) { return presence(mover) * mover.radius; }

}  // namespace bw
