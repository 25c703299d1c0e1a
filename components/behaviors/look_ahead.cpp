#include "components/behaviors/look_ahead.hpp"

#include <algorithm>
#include <cmath>

#include "components/local_planner/footprint_check.hpp"

namespace bw {
namespace {

constexpr double kStep = 0.05;    // [m] of travel between tests
constexpr double kDeeper = 1e-3;  // [m] of gap, and [s] of contact, that rounding does not make
constexpr double kSoon = 0.5;     // [s]: a mover who touches the robot does not walk on through it

MotionGap gap_over(const std::vector<TrajectoryPoint>& trajectory, double margin,
                   const PlanningProblem& problem, double horizon) {
  return gap_along(trajectory, std::min(horizon, trajectory.back().time), kStep, margin, problem);
}

}  // namespace

bool brings_contact(const std::vector<TrajectoryPoint>& motion, const std::vector<TrajectoryPoint>& stop,
                    double margin, const PlanningProblem& problem) {
  const double whole = motion.back().time;
  if (std::isinf(gap_over(motion, margin, problem, whole).contact_time)) return false;
  // One at a time: beside what is near already, something else may come nearer.
  PlanningProblem alone{.footprint = problem.footprint};
  const auto is_worse = [&] {
    const double moving_contact = gap_over(motion, margin, alone, whole).contact_time;
    if (std::isinf(moving_contact)) return false;
    if (moving_contact < gap_over(stop, margin, alone, whole).contact_time - kDeeper) return true;
    if (moving_contact > 0.0) return false;
    const double until = alone.movers.empty() ? whole : kSoon;
    return gap_over(motion, margin, alone, until).gap < gap_over(stop, margin, alone, until).gap - kDeeper;
  };
  const auto any_of = [&](const auto& all, auto& one) {
    for (const auto& item : all) {
      one = {item};
      if (is_worse()) return true;
    }
    one.clear();
    return false;
  };
  return any_of(problem.obstacles.points, alone.obstacles.points) ||
         any_of(problem.obstacles.discs, alone.obstacles.discs) ||
         any_of(problem.obstacles.segments, alone.obstacles.segments) || any_of(problem.movers, alone.movers);
}

}  // namespace bw
