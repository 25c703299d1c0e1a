// A scene of the monitor's property test, driven: sweeps -> CollisionMonitor -> VelocityLimiter -> wheels,
// without any middleware. Touches are judged in the true world.
#pragma once

#include <functional>

#include "tests/components/safety/monitor_scene.hpp"

namespace bw::safety::test {

struct Result {
  double worst = 0.0;  ///< speed at which the robot closed in on what it could see and touched it [m/s]
  double ahead = 0.0;  ///< the same where its laser does not look, in the sector of travel
  double rotated_into = 0.0;  ///< where it does not look, by a rotation in place
  double swept = 0.0;         ///< where it does not look, by a side on an arc
  double hidden = 0.0;        ///< the same of the rest: hidden, thin, dark, or shown by some sweeps only
  double not_braked = 0.0;    ///< of itself where it touched who walks, and had not braked as it must
  double walked_in = 0.0;     ///< of itself where who walks came sooner than it can stand
  double driven = 0.0;        ///< distance of base_link [m]
};
/// A position counts as seen when each sweep of the last second, or stop, shows it, and a contact is what it
/// was when it began: a robot that has touched a thing where it cannot see would not get to where it can. Of
/// who walks the first moment counts. As it must is: by stop_deceleration, reaction_time after the first of
/// the sweeps that show them where a stop would still touch them.
Result run(const Scene& scene);

/// The least scene found of which `excess` still is above zero.
Scene shrunk(Scene scene, const std::function<double(const Result&)>& excess);

}  // namespace bw::safety::test
