#include "components/local_planner/timed_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "components/model/mover_weight.hpp"

namespace bw {
namespace {

constexpr double kCell = 0.5;        // [m]
constexpr double kMaxCells = 40.0;  // per side; beyond the square its outermost cells serve
constexpr double kRounding = 1e-9;   // [m]

}  // namespace

TimedGaps::TimedGaps(const PlanningProblem& problem, double horizon, double step, double reach)
    : footprint_(problem.footprint), reach_(reach) {
  const double speed = std::max(problem.limits.v_max, std::abs(problem.twist.v));
  const auto steps = static_cast<std::size_t>(std::ceil(horizon / step - 1e-9));
  const Vector2 here = problem.pose.position();
  const double aside = problem.footprint.radius + reach;

  const double half = std::min(speed * horizon, 0.5 * kMaxCells * kCell);
  cells_per_side_ = std::max(1, static_cast<int>(std::ceil(2.0 * half / kCell)));
  corner_ = here - Vector2(half, half);
  cells_.resize(static_cast<std::size_t>(cells_per_side_) * static_cast<std::size_t>(cells_per_side_));
  std::vector<Capsule> near;
  for (const Capsule& c : capsules_of(problem.obstacles)) {
    const double limit = speed * horizon + aside + c.radius;
    const Vector2 low = c.a.cwiseMin(c.b) - here, high = c.a.cwiseMax(c.b) - here;
    if (low.maxCoeff() <= limit && high.minCoeff() >= -limit) near.push_back(c);
  }
  statics_ = CapsuleIndex(std::move(near));

  movers_.resize(steps + 1);
  std::vector<const Mover*> confirmed;
  for (const Mover& m : problem.movers) {
    if (is_confirmed(m)) confirmed.push_back(&m);
  }
  for (std::size_t k = 0; k <= steps; ++k) {
    const double time = static_cast<double>(k) * step;
    Placed& placed = movers_[k];
    const auto most = static_cast<Eigen::Index>(confirmed.size());
    placed.x.resize(most);
    placed.y.resize(most);
    placed.radius.resize(most);
    Eigen::Index count = 0;
    for (const Mover* m : confirmed) {
      const Vector2 p = m->position_at(time);
      if ((p - here).norm() - m->radius > speed * time + aside) continue;
      placed.x[count] = p.x();
      placed.y[count] = p.y();
      placed.radius[count++] = m->radius + footprint_.radius;
    }
    placed.x.conservativeResize(count);
    placed.y.conservativeResize(count);
    placed.radius.conservativeResize(count);
  }
}

const TimedGaps::Around& TimedGaps::around(const Vector2& position) {
  const auto index = [&](double x) {
    return std::clamp(static_cast<int>(std::floor(x / kCell)), 0, cells_per_side_ - 1);
  };
  const Vector2 p = position - corner_;
  const int row = index(p.y()), column = index(p.x());
  Around& cell = cells_[static_cast<std::size_t>(row * cells_per_side_ + column)];
  const bool is_outermost =
      row == 0 || column == 0 || row + 1 == cells_per_side_ || column + 1 == cells_per_side_;
  if (cell.found) return cell;
  cell.found = true;
  const Vector2 middle = corner_ + kCell * Vector2(column + 0.5, row + 0.5);
  // Outside of the square serve all that are near.
  const double extent = is_outermost ? 2.0 * kCell * cells_per_side_ : kCell / std::numbers::sqrt2;
  statics_.visit_near(middle, extent + footprint_.radius + reach_ + kRounding,
                      [&](const CapsuleIndex::Group& group) { cell.groups.push_back(group); });
  return cell;
}

TimedGaps::Gap TimedGaps::at(const Pose2& pose, std::size_t k, const Gap& known) {
  const Placed& movers = movers_[std::min(k, movers_.size() - 1)];
  Gap gap{known.all, known.movers, 0};
  if (movers.x.size() > 0) {
    const auto squared = (movers.x - pose.x).square() + (movers.y - pose.y).square();
    // In one sweep without branches: whether anyone is so near that the gap becomes smaller.
    if ((squared - (movers.radius + (gap.movers + kRounding)).square()).minCoeff() < 0.0) {
      for (Eigen::Index i = 0; i < movers.x.size(); ++i) {
        const Vector2 p(movers.x[i], movers.y[i]);
        const double limit = movers.radius[i] + gap.movers + kRounding;
        if ((p - pose.position()).squaredNorm() >= limit * limit) continue;
        gap.movers = std::min(
            gap.movers, gap_to(footprint_, pose, {p, p, movers.radius[i] - footprint_.radius}, gap.movers));
      }
    }
  }
  gap.all = std::min(gap.all, gap.movers);
  const std::vector<CapsuleIndex::Group>& groups = around(pose.position()).groups;
  gap.looks = static_cast<std::size_t>(movers.x.size()) + groups.size();
  for (const CapsuleIndex::Group& group : groups) {
    const double limit = gap.all + footprint_.radius + group.radius + kRounding;
    if (limit <= 0.0 || group.squared_distance(pose.position()) >= limit * limit) continue;
    const auto members = statics_.members(group);
    gap.looks += members.size();
    for (const std::uint32_t i : members) {
      gap.all = std::min(gap.all, gap_to(footprint_, pose, statics_.capsules()[i], gap.all));
    }
  }
  return gap;
}

}  // namespace bw
