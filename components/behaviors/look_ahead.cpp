#include "components/behaviors/look_ahead.hpp"

#include <cmath>
#include <utility>

#include "components/local_planner/footprint_check.hpp"

namespace bw {
namespace {

constexpr double kStep = 0.05;    // [m] of travel between tests
constexpr double kDeeper = 1e-3;  // [m] of gap, and [s] of contact, that rounding does not make

MotionGap gap_over(const std::vector<TrajectoryPoint>& trajectory, double margin, const PlanningProblem& problem) {
  return gap_along(trajectory, trajectory.back().time, kStep, margin, problem);
}

}  // namespace

bool brings_contact(const std::vector<TrajectoryPoint>& motion, const std::vector<TrajectoryPoint>& stop, double margin,
                    const PlanningProblem& problem) {
  if (std::isinf(gap_over(motion, margin, problem).contact_time)) return false;
  // One at a time: beside what is near already, something else may come nearer.
  PlanningProblem alone{.footprint = problem.footprint};
  const auto is_worse = [&] {
    const MotionGap moving = gap_over(motion, margin, alone);
    if (std::isinf(moving.contact_time)) return false;
    const MotionGap standing = gap_over(stop, margin, alone);
    if (moving.contact_time < standing.contact_time - kDeeper) return true;
    return moving.contact_time == 0.0 && moving.gap < standing.gap - kDeeper;
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
