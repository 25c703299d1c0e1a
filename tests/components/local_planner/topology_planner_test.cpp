// Planners on bands in several topologies: what they hold, choose and add.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "components/local_planner/planner_registry.hpp"
#include "components/local_planner/teb/hrvo_preference.hpp"
#include "components/local_planner/teb/teb_options.hpp"
#include "components/model/differential_drive.hpp"

namespace bw {
namespace {

PlanningProblem six_metres_ahead() {
  PlanningProblem problem;
  problem.now = Time::seconds(1.0);
  problem.plan = {{0, 0, 0}, {6, 0, 0}};
  return problem;
}

double side_of(const Candidate& candidate, double x) {
  for (const TrajectoryPoint& p : candidate.trajectory) {
    if (p.pose.x >= x) return p.pose.y;
  }
  return 0.0;
}

const Candidate& chosen(const PlanningResult& result) {
  return *std::find_if(result.candidates.begin(), result.candidates.end(),
                       [](const Candidate& c) { return c.chosen; });
}

TEST(TopologyPlanner, HoldsABandOnBothSidesAndDrivesTheCheaper) {
  PlanningProblem problem = six_metres_ahead();
  problem.obstacles.discs = {{{3.0, 0.4}, 0.4}};  // the path right of it is shorter
  const auto planner = make_planner("teb_homotopy", {});
  planner->plan(problem);  // first plans are not converged, and nothing binds the robot to them
  const PlanningResult result = planner->plan(problem);
  ASSERT_EQ(result.candidates.size(), 2U);
  const auto [cheap, dear] =
      std::minmax_element(result.candidates.begin(), result.candidates.end(),
                          [](const auto& l, const auto& r) { return l.cost < r.cost; });
  EXPECT_TRUE(cheap->chosen);
  EXPECT_EQ(cheap->label, "R");
  EXPECT_EQ(dear->label, "L");
  EXPECT_LT(side_of(*cheap, 3.0), -0.2);
  EXPECT_GT(side_of(*dear, 3.0), 0.9);
  EXPECT_EQ(result.status, PlanningStatus::ok);
}

TEST(TopologyPlanner, TebHasOneBandAlways) {
  PlanningProblem problem = six_metres_ahead();
  problem.obstacles.discs = {{{3.0, 0.4}, 0.4}};
  const auto planner = make_planner("teb", {});
  for (int i = 0; i < 5; ++i) EXPECT_EQ(planner->plan(problem).candidates.size(), 1U);
}

TEST(TopologyPlanner, KeepsItsSideUntilTheOtherIsClearlyCheaper) {
  // A disc on the line: both sides cost the same. Shifted by 1 cm to and fro, a planner without hysteresis
  // would follow every shift.
  PlanningProblem problem = six_metres_ahead();
  const auto planner = make_planner("teb_homotopy", {});
  std::vector<double> sides;
  for (int i = 0; i < 12; ++i) {
    problem.obstacles.discs = {{{3.0, i % 2 == 0 ? 0.01 : -0.01}, 0.4}};
    const PlanningResult result = planner->plan(problem);
    sides.push_back(side_of(chosen(result), 3.0));
    problem.twist = result.command;
    problem.pose = advance_exact(problem.pose, result.command, 0.1);
    problem.now = problem.now + Duration::seconds(0.1);
  }
  for (const double side : sides) EXPECT_GT(side * sides.front(), 0.0);
}

// The disc moves from the left of the line to its right after six cycles: the planner changes sides once, and
// says so in the cycle in which it does.
TEST(TopologyPlanner, TellsThatItSwitchedTheClass) {
  PlanningProblem problem = six_metres_ahead();
  const auto planner = make_planner("teb_homotopy", {});
  problem.obstacles.discs = {{{3.0, 0.4}, 0.4}};
  planner->plan(problem);  // first plans are not converged, and nothing binds the robot to them
  double side = side_of(chosen(planner->plan(problem)), 3.0);
  int switches = 0;
  for (int i = 0; i < 12; ++i) {
    problem.obstacles.discs = {{{3.0, i < 6 ? 0.4 : -0.4}, 0.4}};
    const PlanningResult result = planner->plan(problem);
    const double before = std::exchange(side, side_of(chosen(result), 3.0));
    EXPECT_EQ(result.class_switched, before * side < 0.0) << i;
    if (result.class_switched) ++switches;
    problem.now = problem.now + Duration::seconds(0.1);
  }
  EXPECT_EQ(switches, 1);
}

TEST(TopologyPlanner, BudgetIsSharedAndKept) {
  PlanningProblem problem = six_metres_ahead();
  problem.obstacles.discs = {{{2.0, 0.1}, 0.3}, {{4.0, -0.1}, 0.3}};
  for (const int budget : {1, 4, 20, 100}) {
    problem.budget.max_iterations = budget;
    for (const char* name : {"teb", "teb_homotopy", "pteb", "eteb"}) {
      const auto planner = make_planner(name, {});
      for (int i = 0; i < 3; ++i) EXPECT_LE(planner->plan(problem).iterations, std::max(budget, 4)) << name;
    }
  }
}

TEST(TopologyPlanner, UnsurePredictionsKeepEtebFurtherFromAWalker) {
  // Somebody comes towards the robot on a line 0.9 m beside its own.
  PlanningProblem problem = six_metres_ahead();
  Mover walker;
  walker.position = {6.0, 0.9};
  walker.velocity = {-1.0, 0.0};
  problem.movers = {walker};
  const auto closest = [&](const char* name) {
    const PlanningResult result = make_planner(name, {})->plan(problem);
    double nearest = 1e9;
    for (const TrajectoryPoint& p : result.trajectory)
      nearest = std::min(nearest, (p.pose.position() - walker.position_at(p.time)).norm());
    return nearest;
  };
  EXPECT_GT(closest("eteb"), closest("teb_homotopy") + 0.05);
}

TEST(OtherStarts, AGoalBehindIsReachedWithoutALoop) {
  PlanningProblem problem;
  problem.now = Time::seconds(1.0);
  problem.plan = {{0, 0, std::numbers::pi}, {-4, 0, std::numbers::pi}};
  const auto planner = make_planner("teb", {});
  PlanningResult result = planner->plan(problem);
  ASSERT_EQ(result.candidates.size(), 2U);
  EXPECT_EQ(result.candidates[0].label, "turn first");
  for (const Candidate& c : result.candidates) EXPECT_GE(c.cost, chosen(result).cost);
  double farthest = 0.0;
  for (int i = 0; i < 150; ++i) {
    problem.twist = result.command;
    problem.pose = advance_exact(problem.pose, result.command, 0.1);
    problem.now = problem.now + Duration::seconds(0.1);
    farthest = std::max(farthest, std::abs(problem.pose.y));
    result = planner->plan(problem);
  }
  EXPECT_LT((problem.pose.position() - Vector2(-4.0, 0.0)).norm(), 0.15);
  EXPECT_LT(farthest, 0.7);
}

TEST(OtherStarts, AVerySlowTurnDoesNotFillTheMemory) {
  // Half a turn at 1e-6 rad/s takes 36 days: as many poses as a band may have, and no more.
  PlanningProblem problem;
  problem.now = Time::seconds(1.0);
  problem.limits.omega_max = 1e-6;
  problem.plan = {{0, 0, std::numbers::pi}, {-4, 0, std::numbers::pi}};
  const PlanningResult result = make_planner("teb", {})->plan(problem);
  for (const Candidate& c : result.candidates) EXPECT_LE(c.trajectory.size(), 150U);
}

TEST(OtherStarts, DrivesBackwardOnlyWhereThatIsAllowed) {
  PlanningProblem problem;
  problem.now = Time::seconds(1.0);
  problem.limits.v_back_max = 0.8;
  problem.plan = {{0, 0, 0}, {-1.5, 0, 0}};
  const auto offers_backward = [&](bool allowed) {
    PlannerOptions options;
    options.of<teb::TebOptions>("teb").allow_init_with_backwards_motion = allowed;
    const PlanningResult result = make_planner("teb", options)->plan(problem);
    return std::any_of(result.candidates.begin(), result.candidates.end(),
                       [](const Candidate& c) { return c.label == "backward"; });
  };
  EXPECT_TRUE(offers_backward(true));
  EXPECT_FALSE(offers_backward(false));
}

TEST(HrvoPreference, IsTheAngleBetweenAdviceAndWay) {
  hrvo::Advice advice;
  advice.velocity = {0.5, 0.5};
  std::vector<TrajectoryPoint> straight;
  for (int i = 0; i <= 10; ++i) straight.push_back({0.3 * i, {0.3 * i, 0.0, 0.0}, {1.0, 0.0}});
  const teb::ObstacleField nothing;
  EXPECT_NEAR(teb::hrvo_cost(advice, straight, nothing, 0.5), 0.5 * std::numbers::pi / 4.0, 1e-12);
  advice.velocity = {0.0, 0.01};  // no direction
  EXPECT_DOUBLE_EQ(teb::hrvo_cost(advice, straight, nothing, 0.5), 0.0);
}

TEST(HrvoPreference, LooksAtThePointWhereTheBandPassesTheFirstObstacle) {
  // The band turns left by 45 degrees at 1.5 m; the obstacle is passed at (2.1, 0.6).
  hrvo::Advice advice;
  advice.velocity = {1.0, 0.0};
  std::vector<TrajectoryPoint> trajectory;
  for (int i = 0; i <= 10; ++i)
    trajectory.push_back({0.3 * i, {0.3 * i, std::max(0.0, 0.3 * i - 1.5), 0.0}, {1.0, 0.0}});
  teb::ObstacleField field;
  field.statics = CapsuleIndex({{{2.1, 0.0}, {2.1, 0.0}, 0.3}});
  // Nearest pose to (2.1, 0) on the line y = x - 1.5 among multiples of 0.3: (1.8, 0.3), at 0.424 m.
  EXPECT_NEAR(teb::hrvo_cost(advice, trajectory, field, 1.0), std::atan2(0.3, 1.8), 1e-9);
}

}  // namespace
}  // namespace bw
