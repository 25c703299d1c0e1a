// What a robot meets that holds one velocity: the arc distance to the first contact and the smallest gap.
#pragma once

#include <vector>

#include "components/local_planner/dwa/clearance_field.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::dwa {

/// The arc from `start` at constant `twist`; exact, where (1.1) in steps of 0.1 s is off by some 0.1 mm.
struct Arc {
  Pose2 start;
  Twist2 twist;

  Pose2 at(double time) const;
};

/// Travel s_c [m] until the gap falls to `margin` [m]; 0 if it is no larger at the start; infinite if it does
/// not within `up_to` [m], or when the robot does not travel. Looks at 1000 positions at most and takes the
/// last of them for a contact, so that an endless path along a wall costs no endless time.
double contact_distance(const Arc& arc, const ClearanceField& field, double margin, double up_to);

/// Smallest gap [m] over the first `horizon` seconds, at least as good as tests every `step` [s].
double smallest_gap(const Arc& arc, const ClearanceField& field, double horizon, double step);

/// The same for movers where they are predicted to be, tested every `step` [s]; possible people are as small
/// as their presence is (local_planner/theory.md 7.10).
double smallest_gap(const Arc& arc, const std::vector<Mover>& movers, double robot_radius, double horizon,
                    double step);

}  // namespace bw::dwa
