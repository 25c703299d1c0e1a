#include "components/local_planner/mppi/optimizer.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "components/local_planner/mppi/side.hpp"
#include "tests/components/local_planner/planner_drive.hpp"
#include "tests/components/local_planner/planner_scenes.hpp"

namespace bw::mppi {
namespace {

// exp(0), exp(-1), exp(-2) over their sum 1.503215: 0.665241, 0.244728, 0.090031. A constant changes nothing.
TEST(Softmax, WeighsByTheDifferenceOfCosts) {
  Eigen::ArrayXd costs(3);
  costs << 5.0, 5.3, 5.6;
  const Eigen::ArrayXd weights = softmax_weights(costs, 0.3);
  EXPECT_NEAR(weights[0], 0.665241, 1e-6);
  EXPECT_NEAR(weights[1], 0.244728, 1e-6);
  EXPECT_NEAR(weights[2], 0.090031, 1e-6);
  EXPECT_LT((softmax_weights(costs + 1e6, 0.3) - weights).abs().maxCoeff(), 1e-9);
  costs << 1e9, 0.0, 1e9;
  EXPECT_EQ(softmax_weights(costs, 0.3)[1], 1.0);
}

// 0.015 / 0.2^2 = 0.375 times 0.5 (0.7 - 0.5) + 1 (0.6 - 1) = -0.3.
TEST(DeviationCost, IsWhatWilliamsHas) {
  Eigen::ArrayXXd commands(1, 2);
  commands << 0.7, 0.6;
  Eigen::ArrayXd mean(2), costs = Eigen::ArrayXd::Constant(1, 2.0);
  mean << 0.5, 1.0;
  add_deviation_cost(commands, mean, 0.015, 0.2, costs);
  EXPECT_NEAR(costs[0], 2.0 - 0.375 * 0.3, 1e-12);
}

TEST(Side, IsOppositeInAMirrorAndTheSameElsewhere) {
  Random random(3);
  int left = 0;
  for (int i = 0; i < 200; ++i) {
    const PlanningProblem scene = random_scene(random);
    EXPECT_EQ(side_of(mirrored(scene)), -side_of(scene)) << i;
    EXPECT_EQ(side_of(moved(scene, {100.0, -50.0, 2.0})), side_of(scene)) << i;
    left += side_of(scene) > 0.0;
  }
  EXPECT_GT(left, 40);
  EXPECT_LT(left, 160);
  EXPECT_EQ(side_of(problem_to({3, 0, 0})), 1.0);
}

MppiOptions few_samples() {
  MppiOptions options;
  options.batch_size = 300;
  return options;
}

// Weights sum to 1, so the mean lies among the samples; with a tiny temperature it is the best sample, cut to
// the limits.
TEST(Optimizer, FollowsTheBestSampleWhenItIsCold) {
  MppiOptions options = few_samples();
  options.temperature = 0.001;
  options.time_steps = 20;  // too few to be smoothed
  PlanningProblem problem = problem_to({5, 1, 0});
  problem.control_period = options.model_dt;
  problem.limits.v_max = 9.0;
  problem.limits.v_back_max = 9.0;
  problem.limits.omega_max = 9.0;
  Optimizer optimizer(options);
  const Optimizer::Outcome outcome = optimizer.improve(problem);
  EXPECT_TRUE(outcome.found);
  EXPECT_EQ(outcome.iterations, 1);
  EXPECT_NEAR(optimizer.weights().sum(), 1.0, 1e-12);
  Eigen::Index best = 0;
  EXPECT_GT(optimizer.weights().maxCoeff(&best), 0.99);
  EXPECT_EQ(optimizer.costs()[best], optimizer.costs().minCoeff());
  // The last command is driven by nobody and is cut only here.
  for (Eigen::Index k = 0; k < 19; ++k)
    EXPECT_NEAR(optimizer.controls().v[k], optimizer.samples().command_v(best, k), 0.02) << k;
}

// As often in 0.1 s as Nav2 in two periods of 0.05 s; within the budget.
TEST(Optimizer, SamplesOnceInEachStepOfThePeriod) {
  PlanningProblem problem = problem_to({5, 0, 0});
  Optimizer optimizer(few_samples());
  problem.control_period = 0.05;
  EXPECT_EQ(optimizer.improve(problem).iterations, 1);
  problem.control_period = 0.1;
  EXPECT_EQ(optimizer.improve(problem).iterations, 2);
  problem.control_period = 10.0;
  EXPECT_EQ(optimizer.improve(problem).iterations, 4);
  problem.budget.max_iterations = 3;
  EXPECT_EQ(optimizer.improve(problem).iterations, 3);
}

// A post within the robot: every sample touches it. Two rounds, then two more from standing.
TEST(Optimizer, StartsAnewOnceWhenEverySampleCollides) {
  PlanningProblem problem = problem_to({5, 0, 0});
  Optimizer optimizer(few_samples());
  optimizer.improve(problem);
  EXPECT_NE(optimizer.controls().at(0.0), Twist2{});
  problem.obstacles.points = {{0.1, 0.0}};
  const Optimizer::Outcome outcome = optimizer.improve(problem);
  EXPECT_FALSE(outcome.found);
  EXPECT_EQ(outcome.iterations, 4);
  EXPECT_EQ(optimizer.controls().at(0.0), Twist2{});
}

TEST(Optimizer, DrawsOtherSamplesEachTimeUnlessToldNotTo) {
  for (const bool regenerate : {true, false}) {
    MppiOptions options = few_samples();
    options.regenerate_noises = regenerate;
    PlanningProblem problem = problem_to({5, 0, 0});
    problem.control_period = options.model_dt;
    Optimizer optimizer(options);
    optimizer.improve(problem);
    const double first = optimizer.samples().command_v(7, 55);
    optimizer.controls().reset(56);
    optimizer.improve(problem);
    EXPECT_EQ(optimizer.samples().command_v(7, 55) != first, regenerate);
    optimizer.reset();
    optimizer.improve(problem);
    EXPECT_EQ(optimizer.samples().command_v(7, 55), first);
  }
}

}  // namespace
}  // namespace bw::mppi
