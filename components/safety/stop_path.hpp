// The path that a robot still drives when it is stopped: a last look at what is about to be commanded,
// whatever was driven before.
//
// free_distance.hpp judges the arc of the command. A robot that is on another arc is on neither for a while.
// Here both ends of what may happen are followed step by step: that it goes on as it does for the reaction
// time, or that it takes the command meanwhile; and then brakes to rest (components/model/stopping.hpp).
#pragma once

#include <vector>

#include "components/model/footprint.hpp"
#include "components/model/limits.hpp"
#include "components/safety/action.hpp"
#include "components/safety/sweep.hpp"

namespace bw::safety {

/// Speed [m/s] at which a robot may close in on what touches its outline.
inline constexpr double kGentle = 0.05;

struct StopPath {
  Limits limits;
  double wheel_separation = 0.0;  ///< [m]
  double reaction_time = 0.0;     ///< [s]
};

/// What the robot is told.
struct Told {
  Twist2 command;
  Action action = Action::do_nothing;  ///< anything else: what falls, falls by stop_deceleration
};

/// Largest speed [m/s] (of those above kGentle the first) at which the outline closes in on one of `points`
/// (base_link) while it covers it, on the way of a robot that moves with `now`, is told `told`, and brakes to
/// rest after the reaction time. 0: it covers none, or leads out.
double closing_speed(const StopPath& path, const Footprint& footprint, const Twist2& now, const Told& told,
                     const std::vector<SeenPoint>& points);

}  // namespace bw::safety
