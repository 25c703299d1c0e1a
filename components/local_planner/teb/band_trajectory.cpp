#include "components/local_planner/teb/band_trajectory.hpp"

#include "components/local_planner/command_limits.hpp"
#include "components/model/differential_drive.hpp"

namespace bw::teb {
namespace {

Twist2 blend(const Twist2& a, const Twist2& b, double s) {
  return {a.v + s * (b.v - a.v), a.omega + s * (b.omega - a.omega)};
}

}  // namespace

Twist2 segment_velocity(const Band& band, std::size_t i) {
  const BandPose& a = band.poses[i];
  const BandPose& b = band.poses[i + 1];
  const double rotation = wrap_angle(b.theta - a.theta);
  return {(b.position() - a.position()).dot(direction(a.theta + rotation / 2.0)) / a.dt, rotation / a.dt};
}

Twist2 velocity_at(const Band& band, const Twist2& start, double time) {
  Twist2 before = start;
  double before_time = 0.0;
  double begin = 0.0;
  for (std::size_t i = 0; i + 1 < band.size(); begin += band.poses[i++].dt) {
    const double middle = begin + band.poses[i].dt / 2.0;
    const Twist2 here = segment_velocity(band, i);
    if (time < middle) return blend(before, here, (time - before_time) / (middle - before_time));
    before = here;
    before_time = middle;
  }
  return before;
}

std::vector<TrajectoryPoint> to_trajectory(const Band& band, const Twist2& start, bool goal_at_rest) {
  std::vector<TrajectoryPoint> trajectory;
  trajectory.reserve(band.size());
  double time = 0.0;
  for (std::size_t i = 0; i < band.size(); time += band.poses[i++].dt) {
    Twist2 twist = start;
    if (i + 1 == band.size()) {
      twist = goal_at_rest ? Twist2{} : segment_velocity(band, i - 1);
    } else if (i > 0) {
      const double before = band.poses[i - 1].dt;
      twist = blend(segment_velocity(band, i - 1), segment_velocity(band, i),
                    before / (before + band.poses[i].dt));
    }
    trajectory.push_back({time, band.poses[i].pose(), twist});
  }
  return trajectory;
}

std::vector<TrajectoryPoint> as_driven(const Band& band, const PlanningProblem& problem, double duration,
                                       bool hurried) {
  const double period = problem.control_period;
  std::vector<TrajectoryPoint> motion{{0.0, problem.pose, problem.twist}};
  for (double time = period; time < duration + period; time += period) {
    const TrajectoryPoint& last = motion.back();
    const Twist2 wanted = velocity_at(band, problem.twist, time);
    const Twist2 twist = hurried ? evasive_twist(wanted, last.twist, problem.limits, period)
                                 : reachable_twist(wanted, last.twist, problem.limits, period);
    motion.push_back({time, advance_exact(last.pose, blend(last.twist, twist, 0.5), period), twist});
  }
  return motion;
}

}  // namespace bw::teb
