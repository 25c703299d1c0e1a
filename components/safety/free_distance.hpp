// How far a robot can drive along its present arc until it touches a point, and how fast it may drive there.
#pragma once

#include "components/model/footprint.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::safety {

/// Distance [m] of the disc's centre, starting at the origin with heading 0, along the arc of `twist` until
/// the disc of `radius` [m] touches `point`. Infinity when it never does, and for a rotation in place. A
/// point inside the disc: 0 when the motion goes deeper, infinity when it leads out.
///
/// The centre runs on a circle of radius |rho|, rho = v / omega, around C = (0, rho). With q = |point - C|
/// and phi the angle at C from the start to the point in the direction of travel, contact is at
///   s = |rho| (phi - alpha),  cos(alpha) = (rho^2 + q^2 - radius^2) / (2 |rho| q)
/// and there is none when | q - |rho| | >= radius.
double free_distance(const Twist2& twist, double radius, const Vector2& point);

/// The same for a point that may walk across: once it is anywhere in the way of the disc, as if it stood in
/// the middle of it, where the disc's front reaches it first.
double free_distance_to_walker(const Twist2& twist, double radius, const Vector2& point);
double free_distance_to_walker(const Twist2& twist, const Footprint& footprint, const Vector2& point);

/// What a stop costs.
struct Stopping {
  double reaction_time = 0.1;   ///< [s] until the wheels brake
  double deceleration = 2.0;    ///< [m/s^2]
  double approach_speed = 0.0;  ///< [m/s] at which what is in the way may come nearer meanwhile
};

/// Largest speed v [m/s] from which the robot is down to `end_speed` within `distance` [m] (research: speed
/// and separation; ISO 13855 for the approach u):
///   v t + (v^2 - v_end^2) / 2a + u (t + v / a) <= distance
/// At least end_speed.
double speed_within(double distance, const Stopping& stopping, double end_speed = 0.0);

}  // namespace bw::safety
