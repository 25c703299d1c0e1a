#include "components/local_planner/mppi/costmap.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/components/local_planner/planner_scenes.hpp"

namespace bw::mppi {
namespace {

constexpr double kRadius = 0.3;
const InflationOptions kInflation;

// Nav2's InflationLayer::computeCost, with factor 3 and radius 0.7: 252 exp(-3 (d - 0.3)).
TEST(Inflation, FallsFromTheRobotsRadius) {
  EXPECT_EQ(inflated_cost(-0.1, kRadius, kInflation), 253.0);
  EXPECT_EQ(inflated_cost(0.3, kRadius, kInflation), 253.0);
  EXPECT_NEAR(inflated_cost(0.4, kRadius, kInflation), 186.686192, 1e-6);       // 252 exp(-0.3)
  EXPECT_NEAR(inflated_cost(0.6999999, kRadius, kInflation), 75.900941, 1e-4);  // 252 exp(-1.2)
  EXPECT_EQ(inflated_cost(0.7, kRadius, kInflation), 0.0);
  EXPECT_EQ(inflated_cost(0.29, kRadius, {.inflation_radius = 0.1}), 253.0);
}

PlanningProblem empty_scene(const Pose2& pose) {
  PlanningProblem problem;
  problem.pose = pose;
  problem.footprint.radius = kRadius;
  return problem;
}

// The middle of a cell has the cost of its exact distance; anywhere in the cell costs the same.
TEST(Costmap, HasTheCostOfTheExactDistanceInTheMiddleOfCells) {
  const Pose2 pose{2.0, -1.0, 0.7};
  PlanningProblem problem = empty_scene(pose);
  problem.obstacles.points = {pose * Vector2(1.03, 0.02)};
  problem.obstacles.discs = {{pose * Vector2(-1.2, 0.4), 0.36}};
  problem.obstacles.segments = {{pose * Vector2(0.2, -1.52), pose * Vector2(1.4, -1.12)}};
  problem.movers = {{.id = 1, .position = pose * Vector2(0.1, 1.4), .radius = 0.25}};
  const Costmap costmap(problem, kInflation, 2.0, true);
  int touching = 0, near = 0;
  for (int column = -39; column <= 39; ++column) {
    for (int row = -39; row <= 39; ++row) {
      const Vector2 p(0.05 * column, 0.05 * row);
      const Vector2 a(0.2, -1.52), axis(1.2, 0.4);
      const double share = std::clamp((p - a).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
      const double distance =
          std::min({(p - Vector2(1.03, 0.02)).norm(), (p - Vector2(-1.2, 0.4)).norm() - 0.36,
                    (p - a - share * axis).norm(), (p - Vector2(0.1, 1.4)).norm() - 0.25});
      const double cost = inflated_cost(distance, kRadius, kInflation);
      ASSERT_NEAR(costmap.at(p.x(), p.y()), cost, 1e-9) << p.transpose();
      ASSERT_EQ(costmap.at(p.x() + 0.024, p.y() - 0.024), costmap.at(p.x(), p.y()));
      touching += costmap.touches(p.x(), p.y());
      near += cost > 0.0 && cost < 253.0;
    }
  }
  EXPECT_GT(touching, 300);
  EXPECT_GT(near, 1000);
  EXPECT_EQ(costmap.at(1e6, 0.0), 0.0);
  EXPECT_EQ(Costmap(problem, kInflation, 2.0, false).at(0.1, 1.4), 0.0);  // without movers
}

TEST(Costmap, SeesConfirmedMoversAlone) {
  PlanningProblem problem = empty_scene({});
  problem.movers = {{.id = 1, .position = {1.0, 0.0}, .confidence = 0.49}};
  EXPECT_EQ(Costmap(problem, kInflation, 2.0, true).at(1.0, 0.0), 0.0);
  EXPECT_TRUE(PredictedCosts(problem, kInflation, 3.0, 2.8).empty());
  problem.movers[0].confidence = 0.5;
  EXPECT_EQ(Costmap(problem, kInflation, 2.0, true).at(1.0, 0.0), 253.0);
  EXPECT_FALSE(PredictedCosts(problem, kInflation, 3.0, 2.8).empty());
}

// Whatever is far away or huge, cells stay few: 241 a side.
TEST(Costmap, TakesAnything) {
  PlanningProblem problem = empty_scene({1e5, 2e5, 3.0});
  problem.obstacles.discs = {{{0.0, 0.0}, 1e6}, {{-9e5, 9e5}, 1.0}};
  problem.obstacles.segments = {{{-9e5, -9e5}, {9e5, 9e5}}};
  EXPECT_TRUE(Costmap(problem, kInflation, 1e6, true).touches(0.0, 0.0));
  EXPECT_TRUE(Costmap(problem, kInflation, 0.1, true).touches(0.0, 0.0));
}

// Somebody at (2, 0) walks at -1 m/s: after 1.5 s at (0.5, 0). 0.3 + 0.3 m touch; (0.5, 0.65) is 0.05 m
// further than that.
TEST(PredictedCosts, PutMoversWhereTheyWillBe) {
  const Pose2 pose{-3.0, 5.0, -2.0};
  PlanningProblem problem = empty_scene(pose);
  problem.movers = {{.id = 1, .position = pose * Vector2(2.0, 0.0), .velocity = rotate(pose, {-1.0, 0.0})}};
  const PredictedCosts predicted(problem, kInflation, 3.0, 2.8);
  Eigen::ArrayXd x(5), y(5), costs(5);
  x << 0.5, 0.5, 2.0, 0.5, 0.5;
  y << 0.0, 0.65, 0.0, -1.01, 0.65;
  costs << 0.0, 0.0, 7.0, 3.0, 240.0;
  predicted.raise(x, y, 1.5, costs);
  EXPECT_EQ(costs[0], 253.0);
  EXPECT_NEAR(costs[1], 252.0 * std::exp(-3.0 * 0.05), 1e-9);
  EXPECT_EQ(costs[2], 7.0);    // where somebody was
  EXPECT_EQ(costs[3], 3.0);    // 0.71 m from the rim
  EXPECT_EQ(costs[4], 240.0);  // more than that already
}

}  // namespace
}  // namespace bw::mppi
