#include "components/local_planner/dwa/stopping_motion.hpp"

#include <algorithm>
#include <cmath>

namespace bw::dwa {
namespace {

constexpr double kTimeStep = 0.1;      // [s]
constexpr double kMaxTimeSteps = 100;  // a base that hardly brakes gets longer ones

}  // namespace

std::vector<TrajectoryPoint> stopping_motion(const Arc& arc, double hold, double deceleration) {
  std::vector<TrajectoryPoint> motion{{0.0, arc.start, arc.twist}, {hold, arc.at(hold), arc.twist}};
  const double speed = std::abs(arc.twist.v);
  const double braking = speed / deceleration;
  const double step = std::max(kTimeStep, braking / kMaxTimeSteps);
  for (double time = std::min(step, braking); time > 0.0; time = std::min(time + step, braking)) {
    // All of the motion lies on the arc: braking shows in when a position is reached.
    const double travel = speed * time - 0.5 * deceleration * time * time;
    const double share = std::max(0.0, 1.0 - time / braking);
    motion.push_back(
        {hold + time, arc.at(hold + travel / speed), {arc.twist.v * share, arc.twist.omega * share}});
    if (time >= braking) break;
  }
  return motion;
}

}  // namespace bw::dwa
