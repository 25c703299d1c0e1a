// The velocities that keep clear of one neighbour: a half plane (theory.md 5.6; van den Berg, Guy, Lin,
// Manocha
// 2011). All in one frame; positions [m], velocities [m/s].
#pragma once

#include "components/model/obstacles.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::orca {

/// Allowed is what lies left of the line through `point` along `direction` (a unit vector), and the line
/// itself.
struct HalfPlane {
  Vector2 point{0.0, 0.0};
  Vector2 direction{1.0, 0.0};
};

/// How far outside `velocity` is [m/s]; at most 0 inside.
inline double violation(const HalfPlane& half_plane, const Vector2& velocity) {
  return cross(half_plane.direction, half_plane.point - velocity);
}

/// A disc that moves, as seen from the one who decides.
struct MovingDisc {
  Vector2 offset{0.0, 0.0};    ///< of its centre from the one who decides
  Vector2 velocity{0.0, 0.0};  ///< not relative
  double radius = 0.0;         ///< of both together, above 0
};

/// The velocities that do not touch `other` within `horizon` [s], if the two make the change that this takes
/// together: `share` of it is that of the one who decides, whose velocity is `own` (0.5: both act by this
/// rule; 1: the other does nothing). When they overlap, those that end it within `time_step` [s].
HalfPlane clear_of(const MovingDisc& other, const Vector2& own, double share, double horizon,
                   double time_step);

/// The same for a wall, given from where the one who decides is, that nothing comes nearer to than `radius`
/// (above 0), all of the change their own. Standing is always allowed. Nearer than `radius` already, those
/// that do not approach its nearest point.
HalfPlane clear_of(const Segment& wall, double radius, const Vector2& own, double horizon);

}  // namespace bw::orca
