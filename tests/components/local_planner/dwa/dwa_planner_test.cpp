#include "components/local_planner/dwa/dwa_planner.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "tests/components/local_planner/planner_drive.hpp"
#include "tests/components/local_planner/planner_scenes.hpp"

namespace bw::dwa {
namespace {

struct Form {
  const char* name = "scales";
  Normalisation normalisation = Normalisation::scale;
  bool teaching_sample = false;
};
const std::vector<Form> kForms = {
    {}, {"sum", Normalisation::sum}, {"minmax", Normalisation::minmax}, {"sample", Normalisation::sum, true}};

DwaOptions in(const Form& form) {
  DwaOptions options;
  options.normalisation = form.normalisation;
  options.teaching_sample = form.teaching_sample;
  return options;
}

DwaOptions published(const Form& form = {}) {
  DwaOptions options = in(form);
  options.carrot_distance = 0.0;
  options.arc_to_goal = false;
  options.check_movers = false;
  options.hold_before_braking = false;
  options.leave_margin = false;
  return options;
}

DrivingOptions no_evasion() {
  DrivingOptions options;
  options.evasion_horizon = 0.0;
  return options;
}

PlanningProblem random_problem(Random& random) {
  PlanningProblem problem = problem_to({random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(-3, 3)});
  problem.pose.theta = random.uniform(-3, 3);
  problem.twist = {random.uniform(-0.2, 1.0), random.uniform(-1, 1)};
  for (int i = 0; i < 4; ++i) {
    problem.obstacles.points.push_back({random.uniform(-4, 4), random.uniform(-4, 4)});
    problem.obstacles.discs.push_back({{random.uniform(-4, 4), random.uniform(-4, 4)}, 0.3});
    problem.obstacles.segments.push_back(
        {{random.uniform(-4, 4), random.uniform(-4, 4)}, {random.uniform(-4, 4), random.uniform(-4, 4)}});
    Mover m;
    m.position = {random.uniform(-4, 4), random.uniform(-4, 4)};
    m.velocity = {random.uniform(-1, 1), random.uniform(-1, 1)};
    problem.movers.push_back(m);
  }
  return problem;
}

TEST(DwaPlanner, ArrivesAtRestAtTheGoalHeading) {
  for (const Form& form : kForms) {
    const DwaOptions options = in(form);
    for (const Pose2& goal :
         {Pose2{4, 0, 0}, Pose2{3, 2, 1.5}, Pose2{2, -1, -2.0}, Pose2{-2, 0.5, 3.0}, Pose2{0.3, 0, 0}}) {
      DwaPlanner planner(options, {});
      const Drive result = drive(planner, problem_to(goal), 400);
      EXPECT_TRUE(is_at_rest_at(goal, result)) << form.name << " " << goal.x << " " << goal.y;
    }
  }
}

TEST(DwaPlanner, TurnsIntoAGoalBesideItInsteadOfCirclingIt) {
  // Half a metre to the left: on one arc at 1 rad/s v is at most 1 * 0.5 / 2 = 0.25 m/s.
  const Pose2 goal{0.0, 0.5, 0.0};
  DwaPlanner planner({}, {});
  const Drive result = drive(planner, problem_to(goal), 80);
  EXPECT_TRUE(is_at_rest_at(goal, result));
  for (const Twist2& twist : result.twists)
    EXPECT_LE(twist.v, 0.25 + 0.1) << "one sample period late at most";
}

TEST(DwaPlanner, StraightDriveTakesTheTimeTheLimitsAllow) {
  // 8 m at 1 m/s and 1 m/s^2: 8 + 1 s to rest; 0.1 m before it about 8.6 s.
  DwaPlanner planner({}, {});
  const Drive result = drive(planner, problem_to({8, 0, 0}), 150);
  const auto arrived =
      std::find_if(result.poses.begin(), result.poses.end(), [](const Pose2& p) { return p.x > 7.9; });
  ASSERT_NE(arrived, result.poses.end());
  EXPECT_LE(0.1 * static_cast<double>(arrived - result.poses.begin()), 9.0);
}

TEST(DwaPlanner, BrakesOverTheDistanceThatTheDecelerationNeeds) {
  // A wall straight ahead. Contact at 0.3 + 0.1 m before it. At 1 m/s the braking distance is 0.5 m: with
  // 0.55 m left driving on is admissible, with 0.49 m only v <= sqrt(2 * 0.49 * 1) is.
  const auto fastest = [](double left) {
    PlanningProblem problem = problem_to({8, 0, 0});
    problem.limits.omega_max = 0.01;
    problem.twist = {1.0, 0.0};
    problem.obstacles.segments = {{{left + 0.4, -5.0}, {left + 0.4, 5.0}}};
    DwaOptions options = published();
    options.shown_candidates = 1000;
    DwaPlanner planner(options, {});
    double v = 0.0;
    for (const Candidate& c : planner.plan(problem).candidates) v = std::max(v, c.trajectory[0].twist.v);
    return v;
  };
  EXPECT_DOUBLE_EQ(fastest(0.55), 1.0);
  EXPECT_LE(fastest(0.49), std::sqrt(0.98));
  EXPECT_GE(fastest(0.49), std::sqrt(0.98) - 0.01) << "the next sample below: 0.1 m/s in 10 steps";
}

TEST(DwaPlanner, TurnRateMayBeMadeAdmissibleToo) {
  // Contact after s_c on an arc leaves s_c |w| / v of rotation: |w| <= 2 alpha s_c / v. With alpha 0.05
  // rad/s^2, v 0.7, s_c about 0.4 m: |w| <= 0.057.
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.limits.alpha_max = 0.05;
  problem.command_lead = 0.2;
  problem.twist = {0.7, 0.3};
  problem.obstacles.segments = {{{0.8, -5.0}, {0.8, 5.0}}};
  DwaOptions options = published();
  DwaPlanner loose(options, no_evasion());
  options.limit_turn_rate = true;
  DwaPlanner strict(options, no_evasion());
  EXPECT_EQ(loose.plan(problem).status, PlanningStatus::ok);
  EXPECT_EQ(strict.plan(problem).status, PlanningStatus::infeasible);
}

TEST(DwaPlanner, SlowsDownTowardsAFinalGoalOnly) {
  // sqrt(2 * 1 * 0.32) = 0.8 m/s at 0.32 m.
  PlanningProblem problem = problem_to({0.32, 0, 0});
  problem.twist = {0.85, 0.0};
  DwaPlanner planner({}, {});
  EXPECT_LE(planner.plan(problem).command.v, 0.8 + 1e-12);
  problem.goal_is_final = false;
  EXPECT_GT(planner.plan(problem).command.v, 0.85);
}

TEST(DwaPlanner, NothingAdmissibleBrakesAndReportsIt) {
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.twist = {1.0, 0.4};
  problem.obstacles.segments = {{{0.6, -5.0}, {0.6, 5.0}}};
  DwaPlanner planner(published(), no_evasion());
  const PlanningResult result = planner.plan(problem);
  EXPECT_EQ(result.status, PlanningStatus::infeasible);
  EXPECT_FALSE(result.reason.empty());
  EXPECT_NEAR(result.command.v, 0.8, 1e-12) << "stop_deceleration 2 m/s^2 over 0.1 s";
  EXPECT_NEAR(result.command.omega, 0.25, 1e-12) << "alpha_max 1.5 rad/s^2 over 0.1 s";
}

TEST(DwaPlanner, LeavesTheContactMarginOnlyIfAllowed) {
  // 5 cm beside a wall, goal along it: inside the margin of 10 cm nothing but standing is admissible.
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.obstacles.segments = {{{-9.0, 0.35}, {9.0, 0.35}}};
  DwaPlanner literal(published(), no_evasion());
  EXPECT_EQ(literal.plan(problem).command.v, 0.0);
  DwaPlanner planner({}, {});
  EXPECT_GT(planner.plan(problem).command.v, 0.05);
}

TEST(DwaPlanner, FollowsAPlanAroundAnObstacleAndStopsWithoutOne) {
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.obstacles.discs = {{{3.0, 0.15}, 0.3}};
  // The weights of Table 3.1 never leave the path to the goal: the robot stops at the contact margin, 0.1 m.
  DwaPlanner straight({}, {});
  const Drive stopped_before = drive(straight, problem, 300);
  EXPECT_EQ(stopped_before.twists.back(), Twist2{});
  EXPECT_NEAR(stopped_before.smallest_gap, 0.1, 0.02);

  problem.plan = {{0, 0, 0}, {2, -0.9, 0}, {4, -0.9, 0}, {6, 0, 0}, {8, 0, 0}};
  DwaOptions options;
  options.carrot_distance = 2.0;
  // Over the 3 s of Table 3.1, driving on past an obstacle loses as much clearance as it gains speed.
  options.sim_time = 1.5;
  DwaPlanner planner(options, {});
  const Drive result = drive(planner, problem, 300);
  EXPECT_GT(result.smallest_gap, 0.0);
  EXPECT_LE((result.poses.back().position() - Vector2(8, 0)).norm(), 0.2);
}

TEST(DwaPlanner, FrozenMoversAreWhereTheyAre) {
  // Somebody walks away along the robot's path at 1 m/s, gap 2.4 m. Seen as standing, the gap of 3 s of
  // driving is the larger the slower the robot is; predicted, it is what it is now for every speed.
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.twist = {0.5, 0.0};
  problem.limits.omega_max = 0.01;
  Mover m;
  m.position = {3.0, 0.0};
  m.velocity = {1.0, 0.0};
  problem.movers = {m};
  DwaOptions options = published();
  options.weights.clearance = 10.0;
  DwaPlanner frozen(options, no_evasion());
  options.predict_movers = true;
  DwaPlanner predicting(options, no_evasion());
  EXPECT_NEAR(frozen.plan(problem).command.v, 0.4, 1e-9);
  EXPECT_NEAR(predicting.plan(problem).command.v, 0.6, 1e-9);
}

TEST(DwaPlanner, StandsWhenAMoverWouldMeetItBeforeItCouldStop) {
  // Somebody comes at 1.5 m/s, gap 0.9 m. At 0.7 m/s a stop takes 0.8 s and 0.3 m: he is there before.
  // Standing he would meet the robot too, but nothing that moves is trusted; frozen, 0.9 m are enough to
  // drive on.
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.twist = {0.7, 0.0};
  problem.limits.omega_max = 0.01;
  Mover m;
  m.position = {1.5, 0.0};
  m.velocity = {-1.5, 0.0};
  problem.movers = {m};
  DwaOptions options = published();
  DwaPlanner frozen(options, no_evasion());
  EXPECT_GT(frozen.plan(problem).command.v, 0.6);
  options.check_movers = true;
  DwaPlanner checking(options, no_evasion());
  const PlanningResult result = checking.plan(problem);
  EXPECT_EQ(result.status, PlanningStatus::infeasible);
  EXPECT_NEAR(result.command.v, 0.5, 1e-12) << "stop_deceleration 2 m/s^2 over 0.1 s";
  EXPECT_EQ(result.candidates.size(), 10U) << "what was considered is shown";
}

TEST(DwaPlanner, MirroredSceneGivesMirroredCommands) {
  Random random(11);
  for (const Form& form : kForms) {
    for (int i = 0; i < 40; ++i) {
      const PlanningProblem problem = random_problem(random);
      DwaPlanner planner(published(form), no_evasion());
      const PlanningResult a = planner.plan(problem);
      const PlanningResult b = planner.plan(mirrored(problem));
      EXPECT_EQ(a.status, b.status);
      EXPECT_NEAR(a.command.v, b.command.v, 1e-9) << form.name << " " << i;
      EXPECT_NEAR(a.command.omega, -b.command.omega, 1e-9) << form.name << " " << i;
    }
  }
}

TEST(DwaPlanner, CommandsKeepTheLimitsInAnyScene) {
  Random random(12);
  for (int i = 0; i < 2000; ++i) {
    const PlanningProblem problem = random_problem(random);
    DwaOptions options = in(kForms[static_cast<std::size_t>(i) % kForms.size()]);
    options.v_samples = 5;
    options.omega_samples = 7;
    // Evasive moves, with tests of their own, take most of the time.
    DwaPlanner planner(options, i % 20 == 0 ? DrivingOptions{} : no_evasion());
    const PlanningResult result = planner.plan(problem);
    ASSERT_TRUE(is_finite(result.command)) << i;
    const Limits& l = problem.limits;
    const double change = result.command.v - problem.twist.v;
    EXPECT_LE(
        std::abs(change),
        (std::abs(result.command.v) < std::abs(problem.twist.v) ? l.stop_deceleration : l.acc_max) * 0.1 +
            1e-9);
    EXPECT_LE(std::abs(result.command.omega - problem.twist.omega), l.alpha_max * 0.1 + 1e-9);
    EXPECT_LE(std::abs(result.command.omega), l.omega_max + 1e-9);
    for (const Candidate& c : result.candidates) {
      EXPECT_TRUE(std::isfinite(c.cost));
      for (const TrajectoryPoint& point : c.trajectory) EXPECT_TRUE(is_finite(point.pose));
    }
  }
}

TEST(DwaPlanner, DegenerateInputGivesFiniteCommands) {
  PlanningProblem problem = problem_to({0, 0, 0});
  problem.goal_is_final = false;  // the goal where the robot stands, on the way to another
  problem.obstacles.points = {{0, 0}, {0, 0}};
  problem.obstacles.discs = {{{0, 0}, 0.0}};
  problem.obstacles.segments = {{{1, 1}, {1, 1}}};
  problem.movers.resize(2);
  DwaPlanner planner({}, {});
  DwaPlanner edwa({}, {}, towards_hrvo({}, {}, DrivingOptions{}));
  EXPECT_TRUE(is_finite(planner.plan(problem).command));
  EXPECT_TRUE(is_finite(edwa.plan(problem).command));
}

TEST(DwaPlanner, TypedStatusAndStopOnBadInput) {
  PlanningProblem problem = problem_to({4, 0, 0});
  problem.twist = {0.5, 0.2};
  problem.obstacles.points = {{std::nan(""), 0.0}};
  DwaPlanner planner({}, {});
  const PlanningResult bad = planner.plan(problem);
  EXPECT_EQ(bad.status, PlanningStatus::bad_input);
  EXPECT_FALSE(bad.reason.empty());
  EXPECT_NEAR(bad.command.v, 0.3, 1e-12) << "0.5 m/s less 2 m/s^2 over 0.1 s";
  problem.obstacles = {};
  problem.plan.clear();
  EXPECT_EQ(planner.plan(problem).status, PlanningStatus::no_plan);
}

TEST(DwaPlanner, PlanningCommutesWithTurningTheSceneAndWithTheOrderOfObstacles) {
  Random random(21);
  for (int i = 0; i < 100; ++i) {
    const PlanningProblem problem = random_problem(random);
    PlanningProblem other =
        moved(problem, {random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-3, 3)});
    std::reverse(other.obstacles.points.begin(), other.obstacles.points.end());
    std::reverse(other.obstacles.segments.begin(), other.obstacles.segments.end());
    std::reverse(other.movers.begin(), other.movers.end());
    DwaPlanner planner(published(), no_evasion());
    const PlanningResult a = planner.plan(problem);
    const PlanningResult b = planner.plan(other);
    EXPECT_EQ(a.status, b.status) << i;
    EXPECT_NEAR(a.command.v, b.command.v, 1e-9) << i;
    EXPECT_NEAR(a.command.omega, b.command.omega, 1e-9) << i;
  }
}

TEST(DwaPlanner, ShowsItsBestArcsAndDrivesTheFirst) {
  DwaPlanner planner({}, {});
  const PlanningResult result = planner.plan(problem_to({4, 1, 0}));
  ASSERT_EQ(result.candidates.size(), 10U);
  EXPECT_TRUE(result.candidates[0].chosen);
  EXPECT_EQ(result.candidates[0].trajectory[0].twist, result.command);
  for (std::size_t i = 1; i < result.candidates.size(); ++i) {
    EXPECT_FALSE(result.candidates[i].chosen);
    EXPECT_GE(result.candidates[i].cost, result.candidates[i - 1].cost);
  }
}

}  // namespace
}  // namespace bw::dwa
