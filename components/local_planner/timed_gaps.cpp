#include "components/local_planner/timed_gaps.hpp"

#include <algorithm>
#include <cmath>

#include "components/local_planner/footprint_check.hpp"

namespace bw {

TimedGaps::TimedGaps(const PlanningProblem& problem, double horizon, double step, double reach)
    : footprint_(problem.footprint), reach_(reach) {
  const double speed = std::max(problem.limits.v_max, std::abs(problem.twist.v));
  const auto steps = static_cast<std::size_t>(std::ceil(horizon / step - 1e-9));
  const Pose2& pose = problem.pose;
  // Of the whole outline, wherever the robot turns: its enclosing disc.
  const Footprint disc{.radius = problem.footprint.radius};
  const double everywhere = speed * horizon + reach;
  for (const Vector2& p : problem.obstacles.points) {
    if (gap_to(pose, disc, p, p, 0.0) <= everywhere) statics_.points.push_back(p);
  }
  for (const Disc& d : problem.obstacles.discs) {
    if (gap_to(pose, disc, d.center, d.center, d.radius) <= everywhere) statics_.discs.push_back(d);
  }
  for (const Segment& s : problem.obstacles.segments) {
    if (gap_to(pose, disc, s.a, s.b, 0.0) <= everywhere) statics_.segments.push_back(s);
  }
  movers_.resize(steps + 1);
  for (std::size_t k = 0; k <= steps; ++k) {
    const double time = static_cast<double>(k) * step;
    for (const Mover& m : problem.movers) {
      const Vector2 p = m.position_at(time);
      if (gap_to(pose, disc, p, p, m.radius) <= speed * time + reach) movers_[k].push_back({p, m.radius});
    }
  }
}

TimedGaps::Gap TimedGaps::at(const Pose2& pose, std::size_t k) const {
  Gap gap{reach_, reach_};
  for (const Placed& m : movers_[std::min(k, movers_.size() - 1)]) {
    gap.movers = std::min(gap.movers, gap_to(pose, footprint_, m.position, m.position, m.radius));
  }
  gap.all = std::min(gap.movers, gap_to_statics(pose, footprint_, statics_));
  return gap;
}

}  // namespace bw
