// Each critic on motions whose cost is reckoned by hand; formulas are those of Nav2 (mppi/theory.md 5.8).
#include "components/local_planner/mppi/critics.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace bw::mppi {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Two motions along x, one at 0.5 m/s and one at `v`, of 12 steps of 0.1 s.
class Critics : public testing::Test {
 protected:
  static constexpr Eigen::Index kSteps = 12;
  static constexpr double kDt = 0.1;

  void drive(double v, double omega = 0.0) {
    motions.resize(2, kSteps);
    motions.command_v.row(0).setConstant(0.5);
    motions.command_v.row(1).setConstant(v);
    motions.command_omega.row(0).setConstant(0.0);
    motions.command_omega.row(1).setConstant(omega);
    roll_out(motions, {0.0, 0.0}, {.v_max = 9, .omega_max = 9, .acc_max = 1e3, .alpha_max = 1e3}, kDt);
    costs = Eigen::ArrayXd::Zero(2);
  }
  void plan_straight(double length) {
    path = local_path({{0, 0, 0}, {length, 0, 0}}, {}, length, Costmap(problem, inflation, 6.0, true));
  }
  CriticScene scene(const Pose2& goal, double goal_distance, Eigen::Index furthest = 0) const {
    return {.goal = goal,
            .goal_distance = goal_distance,
            .path = path,
            .costmap = costmap,
            .predicted = predicted,
            .limits = limits,
            .dt = kDt,
            .furthest = furthest};
  }
  void put(const StaticObstacles& obstacles) {
    problem.obstacles = obstacles;
    costmap = Costmap(problem, inflation, 6.0, true);
  }

  PlanningProblem problem;
  InflationOptions inflation;
  Limits limits;
  LocalPath path;
  Costmap costmap{problem, inflation, 6.0, true};
  PredictedCosts predicted{problem, inflation, 6.0, 1.2};
  Rollouts motions;
  Eigen::ArrayXd costs;
};

// The first step stands, eleven are driven: 11 steps 0.1 s (1.3 - 1.0) m/s = 0.33 m too far; backward 11 *
// 0.1 (0.7 - 0.2) = 0.55.
TEST_F(Critics, ConstraintIsTheWayDrivenTooFast) {
  drive(1.3);
  add_constraint_cost({}, scene({}, kInfinity), motions, costs);
  EXPECT_NEAR(costs[0], 0.0, 1e-12);
  EXPECT_NEAR(costs[1], 4.0 * 0.33, 1e-12);
  drive(-0.7);
  add_constraint_cost({.cost_weight = 1.0}, scene({}, kInfinity), motions, costs);
  EXPECT_NEAR(costs[1], 0.55, 1e-12);
}

// 11 * 0.1 s 0.7 m/s back; near the goal any way is as good.
TEST_F(Critics, PreferForwardIsTheWayDrivenBack) {
  drive(-0.7);
  add_prefer_forward_cost({}, scene({}, 0.49), motions, costs);
  EXPECT_EQ(costs[1], 0.0);
  add_prefer_forward_cost({}, scene({}, 0.51), motions, costs);
  EXPECT_EQ(costs[0], 0.0);
  EXPECT_NEAR(costs[1], 5.0 * 0.77, 1e-12);
}

// Distances to a goal 1 m ahead after 0, 0, 0.05, ... 0.55 m are 1 - 0.275 on the mean of 12 steps; standing
// it is 1.
TEST_F(Critics, GoalIsTheMeanDistance) {
  drive(0.0);
  add_goal_cost({}, scene({1.0, 0.0, 0.0}, 1.41), motions, costs);
  EXPECT_EQ(costs[1], 0.0);
  add_goal_cost({}, scene({1.0, 0.0, 0.0}, 1.0), motions, costs);
  EXPECT_NEAR(costs[0], 5.0 * (1.0 - 0.05 * (66.0 / 12.0)), 1e-12);  // 0 + 1 + ... + 11 = 66
  EXPECT_NEAR(costs[1], 5.0, 1e-12);
}

// Headings 0, 0.1, ... 1.1 against a goal of 3 rad: 3 - 0.55 on the mean. Against -3 the short way round is 2
// pi - 3 - theta.
TEST_F(Critics, GoalAngleIsTheMeanDifferenceOfHeadings) {
  drive(0.0, 1.0);
  add_goal_angle_cost({}, scene({0.3, 0.0, 3.0}, 0.51), motions, costs);
  EXPECT_EQ(costs[1], 0.0);
  add_goal_angle_cost({}, scene({0.3, 0.0, 3.0}, 0.3), motions, costs);
  EXPECT_NEAR(costs[0], 3.0 * 3.0, 1e-12);
  EXPECT_NEAR(costs[1], 3.0 * (3.0 - 0.55), 1e-12);
  costs.setZero();
  // From pi - 0.1416 on, headings are nearer the other way: 2 pi - 3 = 3.2832 is more than pi by 0.1416.
  add_goal_angle_cost({.cost_weight = 1.0}, scene({0.3, 0.0, -3.0}, 0.3), motions, costs);
  double sum = 0.0;
  for (int k = 0; k < 12; ++k) sum += std::min(3.0 + 0.1 * k, 2.0 * std::numbers::pi - 3.0 - 0.1 * k);
  EXPECT_NEAR(costs[1], sum / 12.0, 1e-12);
}

// Poses 4 and 8 of every fourth lie at 0.2, 0.4 m (0.5 m/s) and 0.4, 0.8 m; those of an equal path along a
// plan 0.3 m to the left are 0.3 m away, whatever the speed.
TEST_F(Critics, PathAlignComparesEqualWays) {
  drive(1.0);
  plan_straight(3.0);
  path.y.setConstant(0.3);
  add_path_align_cost({}, scene({}, 0.4, 30), motions, costs);
  EXPECT_EQ(costs[1], 0.0) << "near the goal";
  add_path_align_cost({}, scene({}, kInfinity, 19), motions, costs);
  EXPECT_EQ(costs[1], 0.0) << "no motion comes 20 points far";
  add_path_align_cost({}, scene({}, kInfinity, 30), motions, costs);
  EXPECT_NEAR(costs[0], 14.0 * 0.3, 1e-9);
  EXPECT_NEAR(costs[1], 14.0 * 0.3, 1e-9);
}

// Of 30 points 1 or 2 are taken: no matter. Pose 8 of the faster motion is at 0.8 m, point 16, which is one
// of them: only pose 4 counts, 0.1 m of it. Three of 30 are more than 5 %: off.
TEST_F(Critics, PathAlignLeavesOutWhatIsTaken) {
  drive(1.0);
  plan_straight(3.0);
  path.y.setConstant(0.1);
  path.y.segment(16, 1).setConstant(5.0);
  path.free[16] = false;
  add_path_align_cost({.cost_weight = 1.0}, scene({}, kInfinity, 30), motions, costs);
  EXPECT_NEAR(costs[1], 0.1, 1e-9);
  path.free[17] = path.free[18] = false;
  costs.setZero();
  add_path_align_cost({.cost_weight = 1.0}, scene({}, kInfinity, 30), motions, costs);
  EXPECT_EQ(costs[1], 0.0);
}

// Ends at 0.55 and 1.1 m. 22 + 5 points of 0.05 m are 1.35 m ahead; taken up to 1.5 m: 1.55 m.
TEST_F(Critics, PathFollowDrawsToTheNextFreePoint) {
  drive(1.0);
  plan_straight(3.0);
  add_path_follow_cost({}, scene({}, 1.39, 22), motions, costs);
  EXPECT_EQ(costs[1], 0.0) << "near the goal";
  add_path_follow_cost({}, scene({}, kInfinity, 22), motions, costs);
  EXPECT_NEAR(costs[0], 5.0 * 0.8, 1e-9);
  EXPECT_NEAR(costs[1], 5.0 * 0.25, 1e-9);
  for (std::size_t i = 20; i <= 30; ++i) path.free[i] = false;
  costs.setZero();
  add_path_follow_cost({.cost_weight = 1.0}, scene({}, kInfinity, 22), motions, costs);
  EXPECT_NEAR(costs[1], 0.45, 1e-9);
  costs.setZero();
  plan_straight(1.0);  // no further than the end
  add_path_follow_cost({.cost_weight = 1.0}, scene({}, kInfinity, 22), motions, costs);
  EXPECT_NEAR(costs[1], 0.1, 1e-9);
}

// The point 4 beyond the furthest lies at (0, 1): a right angle off, more than 1 rad. Motion 0 ends at (0.55,
// 0) with heading 0: atan2(1, -0.55) = 2.0735 rad. Motion 1 rotates in place to 1.1 rad: pi / 2 - 1.1.
TEST_F(Critics, PathAngleTurnsTowardsThePlan) {
  drive(0.0, 1.0);
  plan_straight(3.0);
  path.x[10] = 0.0;
  path.y[10] = 1.0;
  add_path_angle_cost({}, scene({}, 0.49, 6), motions, costs);
  EXPECT_EQ(costs[0], 0.0) << "near the goal";
  add_path_angle_cost({}, scene({}, kInfinity, 6), motions, costs);
  EXPECT_NEAR(costs[0], 2.0 * std::atan2(1.0, -0.55), 1e-9);
  EXPECT_NEAR(costs[1], 2.0 * (std::numbers::pi / 2.0 - 1.1), 1e-9);
  costs.setZero();
  path.x[10] = 0.7;  // 0.96 rad off
  add_path_angle_cost({}, scene({}, kInfinity, 6), motions, costs);
  EXPECT_EQ(costs[0], 0.0);
}

// A post 0.5 m beside the path at x = 0.4: cells on the way (they are 0.05 m wide, poses lie in their
// middles) cost 252 exp(-3 (d - 0.3)) within 0.7 m. Every second pose of 12 is looked at: 0, 2, ... 10.
TEST_F(Critics, CostIsTheMeanOfTheCells) {
  drive(0.0);
  put({.points = {{0.4, 0.5}}});
  EXPECT_EQ(add_cost_cost({}, scene({}, kInfinity), motions, costs), 2);
  double driven = 0.0, standing = 0.0;
  for (int k = 0; k < 12; k += 2) {
    const auto cost = [](double x) {
      const double d = std::hypot(x - 0.4, 0.5);
      return d < 0.7 ? 252.0 * std::exp(-3.0 * (d - 0.3)) : 0.0;
    };
    driven += cost(0.05 * k);
    standing += cost(0.0);
  }
  EXPECT_NEAR(costs[0], 3.81 / 254.0 * driven / 6.0, 1e-6);
  EXPECT_NEAR(costs[1], 3.81 / 254.0 * standing / 6.0, 1e-6);
  costs.setZero();
  add_cost_cost({}, scene({}, 0.9), motions, costs);
  EXPECT_EQ(costs[0], 0.0) << "within 1 m of the goal only contacts cost";
  costs.setZero();
  // 0.5 m away it costs 138.3; from 130 on that is critical: x = 0.4 alone, and 0.3 and 0.5 m (d 0.51,
  // 134.4).
  add_cost_cost({.near_collision_cost = 130.0}, scene({}, 0.9), motions, costs);
  EXPECT_NEAR(costs[0], 3.81 / 254.0 * 300.0 * 3.0 / 6.0, 1e-9);
}

// Straight into a post at 0.75 m: contact from 0.45 m on. A million, however long.
TEST_F(Critics, CostOfAContactIsThatOfAllOfIt) {
  drive(0.0);
  put({.points = {{0.75, 0.0}}});
  EXPECT_EQ(add_cost_cost({}, scene({}, kInfinity), motions, costs), 1);
  EXPECT_NEAR(costs[0], 3.81 / 254.0 * 1e6 / 6.0, 1e-6);
  EXPECT_EQ(costs[1], 0.0);
  put({.points = {{0.2, 0.0}}});
  EXPECT_EQ(add_cost_cost({}, scene({}, kInfinity), motions, costs), 0);
}

TEST_F(Critics, AreOffWithoutWeight) {
  drive(-9.0, 3.0);
  plan_straight(3.0);
  add_constraint_cost({.cost_weight = 0}, scene({}, 1.0, 30), motions, costs);
  add_goal_cost({.cost_weight = 0}, scene({}, 0.1, 30), motions, costs);
  add_goal_angle_cost({.cost_weight = 0}, scene({}, 0.1, 30), motions, costs);
  add_path_align_cost({.cost_weight = 0}, scene({}, 9.0, 30), motions, costs);
  add_path_follow_cost({.cost_weight = 0}, scene({}, 9.0, 30), motions, costs);
  add_path_angle_cost({.cost_weight = 0}, scene({}, 9.0, 30), motions, costs);
  add_prefer_forward_cost({.cost_weight = 0}, scene({}, 9.0, 30), motions, costs);
  EXPECT_TRUE((costs == 0.0).all());
}

}  // namespace
}  // namespace bw::mppi
