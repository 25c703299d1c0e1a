#include "components/local_planner/timed_gaps.hpp"

#include <algorithm>
#include <cmath>

#include "components/local_planner/footprint_check.hpp"
#include "components/model/mover_weight.hpp"

namespace bw {
namespace {

constexpr double kCell = 0.5;        // [m]
constexpr double kMostCells = 40.0;  // per side; beyond the square its outermost cells serve

}  // namespace

TimedGaps::TimedGaps(const PlanningProblem& problem, double horizon, double step, double reach)
    : footprint_(problem.footprint), reach_(reach) {
  const double speed = std::max(problem.limits.v_max, std::abs(problem.twist.v));
  const auto steps = static_cast<std::size_t>(std::ceil(horizon / step - 1e-9));
  const Vector2 here = problem.pose.position();
  const double around = problem.footprint.radius + reach;

  const double half = std::min(speed * horizon, 0.5 * kMostCells * kCell);
  cells_per_side_ = std::max(1, static_cast<int>(std::ceil(2.0 * half / kCell)));
  corner_ = here - Vector2(half, half);
  statics_.resize(static_cast<std::size_t>(cells_per_side_) * static_cast<std::size_t>(cells_per_side_));
  const auto file = [&](const Vector2& a, const Vector2& b, double radius) {
    const auto index = [&](double x) {
      return std::clamp(static_cast<int>(std::floor(std::clamp(x / kCell, -1.0, kMostCells + 1.0))), 0,
                        cells_per_side_ - 1);
    };
    const Vector2 low = a.cwiseMin(b) - corner_ - Vector2::Constant(radius + around);
    const Vector2 high = a.cwiseMax(b) - corner_ + Vector2::Constant(radius + around);
    if (high.x() < 0.0 || high.y() < 0.0 || low.minCoeff() > 2.0 * half || low.x() > 2.0 * half ||
        low.y() > 2.0 * half) {
      return;
    }
    for (int row = index(low.y()); row <= index(high.y()); ++row) {
      for (int column = index(low.x()); column <= index(high.x()); ++column) {
        statics_[static_cast<std::size_t>(row * cells_per_side_ + column)].push_back({a, b, radius});
      }
    }
  };
  for (const Vector2& p : problem.obstacles.points) file(p, p, 0.0);
  for (const Disc& d : problem.obstacles.discs) file(d.center, d.center, d.radius);
  for (const Segment& s : problem.obstacles.segments) file(s.a, s.b, 0.0);

  movers_.resize(steps + 1);
  for (std::size_t k = 0; k <= steps; ++k) {
    const double time = static_cast<double>(k) * step;
    for (const Mover& m : problem.movers) {
      if (!is_confirmed(m)) continue;
      const Vector2 p = m.position_at(time);
      if ((p - here).norm() - m.radius <= speed * time + around) movers_[k].push_back({p, m.radius});
    }
  }
}

std::size_t TimedGaps::cell_of(const Vector2& position) const {
  const auto index = [&](double x) {
    return std::clamp(static_cast<int>(std::floor(x / kCell)), 0, cells_per_side_ - 1);
  };
  const Vector2 p = position - corner_;
  return static_cast<std::size_t>(index(p.y()) * cells_per_side_ + index(p.x()));
}

TimedGaps::Gap TimedGaps::at(const Pose2& pose, std::size_t k) const {
  const std::vector<Placed>& movers = movers_[std::min(k, movers_.size() - 1)];
  const std::vector<Core>& statics = statics_[cell_of(pose.position())];
  const std::size_t edges = std::max<std::size_t>(1, footprint_.polygon.size());
  Gap gap{reach_, reach_, edges * (movers.size() + statics.size())};
  for (const Placed& m : movers) {
    gap.movers = std::min(gap.movers, gap_to(pose, footprint_, m.position, m.position, m.radius));
  }
  gap.all = gap.movers;
  for (const Core& c : statics) {
    gap.all = std::min(gap.all, gap_to(pose, footprint_, c.a, c.b, c.radius));
  }
  return gap;
}

}  // namespace bw
