// Candidates planned by several threads are those planned one after the other, to the last bit.
#include <string>

#include <gtest/gtest.h>

#include "components/local_planner/planner_registry.hpp"
#include "components/model/differential_drive.hpp"
#include "components/model/random.hpp"
#include "runtime/worker_pool.hpp"

namespace bw {
namespace {

class EveryPlannerInParallel : public testing::TestWithParam<std::string_view> {};
INSTANTIATE_TEST_SUITE_P(ParallelPlanning, EveryPlannerInParallel, testing::ValuesIn(planner_names()),
                         [](const auto& planner) { return std::string(planner.param); });

/// 6 m among three discs and three people who cross.
PlanningProblem random_problem(Random& random) {
  PlanningProblem problem;
  problem.plan = {{0, 0, 0}, {1.5, 0, 0}, {3, 0, 0}, {4.5, 0, 0}, {6, 0, 0}};
  for (int i = 0; i < 3; ++i) {
    const Vector2 at(random.uniform(1.5, 5.0), random.uniform(-1.5, 1.5));
    problem.obstacles.discs.push_back({at, 0.2});
    Mover mover;
    mover.id = static_cast<std::uint32_t>(i);
    mover.position = {random.uniform(2.0, 6.0), random.uniform(-3.0, 3.0)};
    mover.velocity = {random.uniform(-1.0, 0.5), random.uniform(-0.6, 0.6)};
    for (int k = 1; k <= 6; ++k) {
      mover.predictions.push_back(
          {0.5 * k, mover.position + 0.5 * k * mover.velocity, 0.02 * k * Eigen::Matrix2d::Identity()});
    }
    problem.movers.push_back(mover);
  }
  return problem;
}

void expect_same(const PlanningResult& a, const PlanningResult& b, const std::string& where) {
  EXPECT_EQ(a.status, b.status) << where;
  EXPECT_EQ(a.command, b.command) << where;
  EXPECT_EQ(a.iterations, b.iterations) << where;
  ASSERT_EQ(a.candidates.size(), b.candidates.size()) << where;
  for (std::size_t i = 0; i < a.candidates.size(); ++i) {
    EXPECT_EQ(a.candidates[i].label, b.candidates[i].label) << where;
    EXPECT_EQ(a.candidates[i].cost, b.candidates[i].cost) << where;
    EXPECT_EQ(a.candidates[i].chosen, b.candidates[i].chosen) << where;
  }
  ASSERT_EQ(a.trajectory.size(), b.trajectory.size()) << where;
  for (std::size_t i = 0; i < a.trajectory.size(); ++i)
    EXPECT_EQ(a.trajectory[i].pose, b.trajectory[i].pose) << where;
}

TEST_P(EveryPlannerInParallel, GivesTheSameAsSerially) {
  WorkerPool pool(4);
  std::size_t calls = 0;
  const std::string name(GetParam());
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Random random(seed);
    PlanningProblem problem = random_problem(random);
    const auto serial = make_planner(name, {});
    const auto parallel = make_planner(name, {});
    for (int cycle = 0; cycle < 5; ++cycle) {
      const PlanningResult expected = serial->plan(problem);
      PlanningProblem shared = problem;
      shared.parallel_for = [&](std::size_t count, const std::function<void(std::size_t)>& body) {
        ++calls;
        pool.run(count, body);
      };
      expect_same(parallel->plan(shared), expected, name + " seed " + std::to_string(seed));
      problem.twist = expected.command;
      problem.pose = advance_exact(problem.pose, problem.twist, 0.1);
      problem.now = problem.now + Duration::milliseconds(100);
      for (Mover& mover : problem.movers) {
        mover.position = mover.position_at(0.1);
        mover.predictions.clear();
      }
    }
  }
  if (name == "teb_homotopy" || name == "pteb" || name == "eteb") {
    EXPECT_GT(calls, 0U) << "never asked for parallel work";
  }
}

}  // namespace
}  // namespace bw
