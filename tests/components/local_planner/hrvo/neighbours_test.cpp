#include "components/local_planner/hrvo/neighbours.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace bw::hrvo {
namespace {

const Vector2 kGoal(6.0, 0.0);

Mover mover_at(const Vector2& position) {
  Mover m;
  m.position = position;
  return m;
}

TEST(Neighbours, WithinRangeAndViewOnly) {
  // 270 degrees: up to 135 to each side of the heading.
  PlanningProblem problem;
  problem.movers = {mover_at({7.9, 0.0}), mover_at({8.1, 0.0}), mover_at(3.0 * direction(2.30)),
                    mover_at(3.0 * direction(-2.40))};
  const std::vector<Neighbour> seen = neighbours(problem, kGoal, {});
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_NEAR(seen[0].distance, 3.0, 1e-12) << "131.8 degrees to the left";
  EXPECT_NEAR(seen[1].distance, 7.9, 1e-12);
}

TEST(Neighbours, RadiusIsTheSumAndTheMargin) {
  PlanningProblem problem;
  problem.movers = {mover_at({2.0, 0.0})};
  problem.obstacles.discs = {{{0.0, 3.0}, 0.4}};
  const std::vector<Neighbour> seen = neighbours(problem, kGoal, {});
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_NEAR(seen[0].radius, 0.3 + 0.3 + 0.2, 1e-12);
  EXPECT_NEAR(seen[1].radius, 0.3 + 0.4 + 0.2, 1e-12);
}

TEST(Neighbours, AWallOfPointsDoesNotHidePeople) {
  PlanningProblem problem;
  for (int i = 0; i < 200; ++i) problem.obstacles.points.emplace_back(0.05 * i - 3.0, 0.9);
  problem.obstacles.segments = {{{-3.0, -1.2}, {7.0, -1.2}}};
  for (int i = 0; i < 12; ++i) problem.movers.push_back(mover_at({3.0 + 0.2 * i, 0.11 * i}));
  const std::vector<Neighbour> seen = neighbours(problem, kGoal, {});
  EXPECT_EQ(seen.size(), 20U) << "10 movers and 10 static ones";
  EXPECT_EQ(std::count_if(seen.begin(), seen.end(), [](const Neighbour& n) { return n.core.a.x() == 3.0; }),
            1)
      << "the nearest mover";
  EXPECT_EQ(std::count_if(seen.begin(), seen.end(), [](const Neighbour& n) { return n.core.a.y() == -1.2; }),
            1)
      << "the other wall";
  std::vector<double> xs;
  for (const Neighbour& n : seen)
    if (n.core.a.y() == 0.9) xs.push_back(n.core.a.x());
  std::sort(xs.begin(), xs.end());
  for (std::size_t i = 1; i < xs.size(); ++i) {
    EXPECT_GE(xs[i] - xs[i - 1], 0.3 - 1e-9);
    EXPECT_LE(xs[i] - xs[i - 1], 0.6) << "no gap that a disc of 0.5 m would fit through";
  }
}

TEST(Neighbours, NearestGapFirst) {
  PlanningProblem problem;
  problem.movers = {mover_at({3.0, 0.0}), mover_at({2.0, 0.0})};
  problem.movers[0].radius = 2.0;
  const std::vector<Neighbour> seen = neighbours(problem, kGoal, {});
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_NEAR(seen[0].distance, 3.0, 1e-12) << "gap 0.5 m against 1.2 m";
}

TEST(Neighbours, WallBehindTheGoalIsNoHindrance) {
  PlanningProblem problem;
  problem.plan = {{0, 0, 0}, {kGoal.x(), 0, 0}};
  problem.obstacles.segments = {{{6.35, -5.0}, {6.35, 5.0}}};
  EXPECT_TRUE(neighbours(problem, kGoal, {}).empty()) << "0.35 m behind the goal, footprint 0.3 m";
  problem.goal_is_final = false;
  EXPECT_EQ(neighbours(problem, kGoal, {}).size(), 1U) << "nobody will stop there";
  problem.goal_is_final = true;
  problem.plan.back().x = 6.2;
  EXPECT_EQ(neighbours(problem, {6.2, 0.0}, {}).size(), 1U) << "the footprint does not fit there";
}

TEST(Neighbours, OnlyThePartOfAWallThatIsInReach) {
  // Radius 0.3 + 0.2 and 2 m to the goal: within 2.5 m of the robot, sqrt(6.25 - 1) to each side.
  PlanningProblem problem;
  problem.obstacles.segments = {{{-50.0, 1.0}, {1.5, 1.0}}};
  const std::vector<Neighbour> seen = neighbours(problem, {2.0, 0.0}, {});
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_NEAR(seen[0].core.a.x(), -std::sqrt(5.25), 1e-12);
  EXPECT_NEAR(seen[0].core.a.y(), 1.0, 1e-12);
  EXPECT_EQ(seen[0].core.b, Vector2(1.5, 1.0));
}

TEST(Neighbours, MarginShrinksToTheRoomThatIsThere) {
  PlanningProblem problem;
  problem.obstacles.segments = {{{-5.0, 0.4}, {5.0, 0.4}}, {{-5.0, -0.2}, {5.0, -0.2}}};
  const std::vector<Neighbour> seen = neighbours(problem, kGoal, {});
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_NEAR(seen[0].radius, 0.3, 1e-12) << "in contact: no margin";
  EXPECT_NEAR(seen[1].radius, 0.4, 1e-12) << "0.1 m of room";
}

TEST(Neighbours, OnlyKnownOnesShareUnlessAllAreTrusted) {
  PlanningProblem problem;
  problem.movers = {mover_at({2.0, 0.0}), mover_at({3.0, 0.0})};
  problem.movers[1].reciprocal = true;
  std::vector<Neighbour> seen = neighbours(problem, kGoal, {});
  EXPECT_FALSE(seen[0].shares);
  EXPECT_TRUE(seen[1].shares);
  HrvoOptions trusting;
  trusting.reciprocity = Reciprocity::all;
  seen = neighbours(problem, kGoal, trusting);
  EXPECT_TRUE(seen[0].shares && seen[1].shares);
}

}  // namespace
}  // namespace bw::hrvo
