// Random and degenerate scenes: a finite command within limits and a typed status, always.
#include <cmath>

#include <gtest/gtest.h>

#include "components/local_planner/teb/band_planner.hpp"
#include "components/model/random.hpp"

namespace bw::teb {
namespace {

constexpr std::uint64_t kSeed = 23;

PlanningProblem random_problem(Random& random, int index) {
  const auto point = [&] { return Vector2(random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0)); };
  PlanningProblem problem;
  problem.now = Time::seconds(0.1 * index);
  problem.twist = {random.uniform(-0.2, 1.0), random.uniform(-1.0, 1.0)};
  problem.pose = {0.0, 0.0, random.uniform(-3.2, 3.2)};
  for (int i = index % 5; i >= 0; --i) {
    const Vector2 p = index % 7 == 0 ? Vector2(0.0, 0.0) : point();
    problem.plan.push_back({p.x(), p.y(), random.uniform(-3.2, 3.2)});
  }
  const int obstacles = index % 50 == 0 ? 1000 : index % 20;
  for (int i = 0; i < obstacles; ++i) problem.obstacles.points.push_back(point());
  for (int i = 0; i < index % 4; ++i) problem.obstacles.discs.push_back({point(), random.uniform(0.0, 1.0)});
  for (int i = 0; i < index % 3; ++i)
    problem.obstacles.segments.push_back({point(), i % 2 == 0 ? point() : Vector2(1, 1)});
  for (int i = 0; i < index % 6; ++i) {
    Mover m;
    m.position = point();
    m.velocity = {random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)};
    if (i % 2 == 0) m.predictions.resize(3);  // out of order on purpose
    for (std::size_t k = 0; k < m.predictions.size(); ++k) {
      m.predictions[k].time = 0.9 - 0.4 * static_cast<double>(k);
      m.predictions[k].position = point();
    }
    problem.movers.push_back(m);
  }
  if (index % 11 == 0) problem.obstacles.points.push_back(problem.pose.position());
  if (index % 13 == 0) problem.obstacles.discs.push_back({problem.plan.back().position(), 0.5});
  if (index % 97 == 0) problem.obstacles.points.push_back({std::nan(""), 0.0});
  if (index % 101 == 0) problem.obstacles.points.push_back({1e300, 0.0});
  problem.goal_is_final = index % 3 != 0;
  return problem;
}

TEST(TebRobustness, CommandIsFiniteAndWithinLimitsInRandomScenes) {
  Random random(kSeed);
  BandPlanner planner({});
  for (int i = 0; i < 3000; ++i) {
    const PlanningProblem problem = random_problem(random, i);
    if (i % 3 == 0) planner.reset();
    const PlanningResult result = planner.plan(problem);
    ASSERT_TRUE(is_finite(result.command)) << "seed " << kSeed << " case " << i;
    const Limits& limits = problem.limits;
    ASSERT_LE(std::abs(result.command.v - problem.twist.v), limits.stop_deceleration * 0.1 + 1e-9) << i;
    ASSERT_LE(std::abs(result.command.omega - problem.twist.omega), limits.alpha_max * 0.1 + 1e-9) << i;
    ASSERT_LE(result.command.v, limits.v_max + 1e-9) << i;
    ASSERT_LE(result.iterations, problem.budget.max_iterations) << i;
    for (const TrajectoryPoint& p : result.trajectory)
      ASSERT_TRUE(is_finite(p.pose) && is_finite(p.twist)) << i;
    if (i % 97 == 0 || i % 101 == 0) {
      ASSERT_EQ(result.status, PlanningStatus::bad_input) << i;
    }
  }
}

}  // namespace
}  // namespace bw::teb
