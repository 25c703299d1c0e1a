#include "components/local_planner/dwa/passing_cost.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "components/local_planner/dwa/critics_planner.hpp"
#include "tests/components/local_planner/planner_drive.hpp"

namespace bw::dwa {
namespace {

/// At 1 m/s along x; robot and person 0.3 m each.
PlanningProblem driving_with(const Vector2& position, const Vector2& velocity) {
  PlanningProblem problem = problem_to({16, 0, 0});
  problem.twist = {1.0, 0.0};
  Mover mover;
  mover.position = position;
  mover.velocity = velocity;
  problem.movers = {mover};
  return problem;
}

EdwaOptions options() {
  EdwaOptions options;
  options.mover_horizon = 3.0;
  options.passing_scale = 200.0;
  options.passing_gap = 0.8;
  options.passing_power = 1.0;
  options.passing_fading = 0.0;
  return options;
}

TEST(PassingCost, IsTheShareOfTheGapThatIsMissing) {
  // Side by side at 1 m/s, 1 m between centres: 0.4 m of 0.8 m.
  EXPECT_NEAR(PassingCost(driving_with({0, 1.0}, {1, 0}), options()).of({1, 0}), 100.0, 1e-6);
  EXPECT_NEAR(PassingCost(driving_with({0, 1.5}, {1, 0}), options()).of({1, 0}), 0.0, 1e-6);
}

TEST(PassingCost, TellsMotionsApartThatTouch) {
  // Head-on at 1 m/s each from 6 m: 0.3 m deep after 2.85 s, 200 (1.1 / 0.8 + 0.15 / 3); from 4 m after 1.85
  // s. Movers are placed each 0.1 s, which is 6.7.
  EXPECT_NEAR(PassingCost(driving_with({6, 0}, {-1, 0}), options()).of({1, 0}), 285.0, 7.0);
  EXPECT_NEAR(PassingCost(driving_with({4, 0}, {-1, 0}), options()).of({1, 0}), 351.7, 7.0);
  // Grazed by 0.1 m: less than to run into them.
  EXPECT_NEAR(PassingCost(driving_with({4, 0.5}, {-1, 0}), options()).of({1, 0}), 225.0, 1.0);
}

// Half of the gap is missing now: 200 / 4. Head-on from 6 m, touched 0.3 m deep after 3.8 s at 0.5 m/s: not
// yet; from 4 m after 2.47 s:
// 200 ((1.1 / 0.8)^2 (1 - 0.7 2.47 / 3) + 0.18); movers are placed each 0.1 s.
TEST(PassingCost, OfSlowerPeopleGrowsWithItsPowerAndFadesWithTime) {
  EdwaOptions fading = options();
  fading.passing_power = 2.0;
  fading.passing_fading = 0.7;
  const auto cost_of = [&](const Vector2& position, const Vector2& velocity) {
    PlanningProblem walkers = driving_with(position, velocity);
    walkers.limits.v_max = 1.5;
    return PassingCost(walkers, fading).of({1, 0});
  };
  EXPECT_NEAR(cost_of({0, 1.0}, {1, 0}), 50.0, 1e-6);
  const double touched = 200.0 * (std::pow(1.1 / 0.8, 2) * (1.0 - 0.7 * 2.467 / 3.0) + 1.0 - 2.467 / 3.0);
  EXPECT_NEAR(cost_of({4, 0}, {-0.5, 0}), touched, 16.0);
  // Who overtakes at 1.4 m/s and is 0.2 m away in 2.5 s counts less than who is that near now: 200 (0.6 /
  // 0.8)^2 = 112.5.
  EXPECT_NEAR(cost_of({0, 0.8}, {1, 0}), 112.5, 1e-6);
  EXPECT_NEAR(cost_of({-1, 0.8}, {1.4, 0}), 112.5 * (1.0 - 0.7 * 2.5 / 3.0), 3.0);
  // Faster than the robot can be: all of the share, whenever.
  EXPECT_NEAR(cost_of({-2, 0.8}, {2, 0}), 150.0, 3.0);
}

TEST(PassingCost, IsOfPeopleWhoWalkAlone) {
  const auto cost_of = [](const PlanningProblem& problem) {
    const PlanningProblem walkers = walkers_alone(problem);
    return PassingCost(walkers, options()).of({1, 0});
  };
  EXPECT_GT(cost_of(driving_with({4, 0}, {-1, 0})), 0.0);
  EXPECT_EQ(cost_of(driving_with({2, 0}, {0, 0})), 0.0);
  PlanningProblem possible = driving_with({4, 0}, {-1, 0});
  possible.movers[0].confidence = 0.45;
  EXPECT_EQ(cost_of(possible), 0.0);
}

TEST(PassingCost, WhoIsMetAfterTheRollOutIsEvaded) {
  // Contact after (5 - sqrt(0.6^2 - 0.4^2)) / 2 = 2.28 s: the roll-out ends after 1.7 s, the check after 3 s.
  // No other term leads round them.
  EdwaOptions blind = options();
  blind.heading_scale = blind.advised_speed_scale = blind.passing_scale = 0.0;
  CriticsPlanner planner({}, {}, blind, {});
  const PlanningResult evading = planner.plan(driving_with({5, 0.4}, {-1, 0}));
  EXPECT_EQ(evading.status, PlanningStatus::ok);
  EXPECT_EQ(evading.reason, "evading");
  EXPECT_EQ(planner.plan(driving_with({5, 2}, {-1, 0})).reason, "");
}

}  // namespace
}  // namespace bw::dwa
