// People who come from the side or from behind and react to nobody: one who turns into the robot's path, one
// who overtakes, one who walks over the position where the robot waits. Closed loop, ideal unicycle, true
// positions and velocities; nobody tells the planner that somebody is about to turn.
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "components/local_planner/footprint_check.hpp"
#include "components/local_planner/planner_registry.hpp"
#include "components/local_planner/teb/prediction_options.hpp"
#include "components/model/differential_drive.hpp"
#include "tests/shortfall.hpp"

namespace bw {
namespace {

constexpr double kPeriod = 0.1;   // [s]
constexpr double kStep = 0.02;    // [s]
constexpr double kFast = 0.9;     // [m/s] of a robot that is under way
constexpr double kWalking = 1.3;  // [m/s]

/// Velocity of somebody `time` seconds after the start.
using Gait = std::function<Vector2(double time)>;

struct Walker {
  Vector2 position{0.0, 0.0};
  Gait gait;
};

struct Outcome {
  double smallest_gap = 1e9;  ///< [m]
  bool reached = false;
};

/// What commands the robot in a period.
using Driver = std::function<Twist2(const PlanningProblem& problem)>;

Outcome drive_among(std::vector<Walker> walkers, double speed, double duration, const Driver& driver,
                    const Limits& limits = {}) {
  PlanningProblem problem;
  problem.limits = limits;
  problem.plan = {{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}};
  problem.twist = {speed, 0.0};
  problem.movers.resize(walkers.size());
  Outcome outcome;
  for (double time = 0.0; time < duration && !outcome.reached; time += kPeriod) {
    problem.now = Time::seconds(1.0 + time);
    for (std::size_t i = 0; i < walkers.size(); ++i) {
      problem.movers[i].id = static_cast<std::uint32_t>(i + 1);
      problem.movers[i].position = walkers[i].position;
      problem.movers[i].velocity = walkers[i].gait(time);
    }
    problem.twist = driver(problem);
    for (double t = 0.0; t < kPeriod - 1e-9; t += kStep) {
      problem.pose = advance_exact(problem.pose, problem.twist, kStep);
      for (std::size_t i = 0; i < walkers.size(); ++i) {
        walkers[i].position += kStep * walkers[i].gait(time + t);
        problem.movers[i].position = walkers[i].position;
      }
      outcome.smallest_gap =
          std::min(outcome.smallest_gap, gap_at(problem.pose, 0.0, problem.footprint, {}, problem.movers));
    }
    outcome.reached = (problem.pose.position() - problem.plan.back().position()).norm() < 0.2;
  }
  return outcome;
}

Outcome drive_eteb(const std::vector<Walker>& walkers, double speed, double duration,
                   const Limits& limits = {}, const PlannerOptions& options = {}) {
  const std::unique_ptr<LocalPlanner> planner = make_planner("eteb", options);
  return drive_among(
      walkers, speed, duration,
      [&](const PlanningProblem& problem) { return planner->plan(problem).command; }, limits);
}

/// Whoever drives straight on as fast as it can.
Outcome drive_on(const std::vector<Walker>& walkers, double speed, double duration) {
  return drive_among(walkers, speed, duration, [](const PlanningProblem& problem) {
    return Twist2{std::min(problem.limits.v_max, problem.twist.v + problem.limits.acc_max * kPeriod), 0.0};
  });
}

/// Along x, and from `begin` on within 1.5 s a quarter of a turn to the right.
Gait turning_right(double begin) {
  return [=](double time) {
    const double share = std::clamp((time - begin) / 1.5, 0.0, 1.0);
    return Vector2(kWalking * direction(-share * std::numbers::pi / 2.0));
  };
}

// Somebody walks along to the left of the robot and turns into its path. None should meet it. Scenes are
// given and nothing is drawn, so the figures have no noise.
TEST(FromAllSides, OneWhoTurnsIntoTheWay) {
  int scenes = 0, contacts = 0, needless = 0;
  for (int ahead = -4; ahead <= 4; ++ahead) {
    for (const double aside : {1.2, 1.6, 2.0}) {
      for (const double begin : {0.5, 1.5}) {
        const std::vector<Walker> walkers = {{{0.25 * ahead, aside}, turning_right(begin)}};
        const bool contact = drive_eteb(walkers, kFast, 8.0).smallest_gap < 0.0;
        ++scenes;
        contacts += contact ? 1 : 0;
        needless += contact && drive_on(walkers, kFast, 8.0).smallest_gap > 0.0 ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(scenes, 54);
  test::expect_at_most("contacts with one who turns, of 54", {.asked = 0, .measured = 11}, contacts);
  test::expect_at_most("of these where driving on would have cleared", {.asked = 0, .measured = 1}, needless);
}

// From 2 m behind, in its lane and beside it, faster than the robot can be.
TEST(FromAllSides, OneWhoOvertakesFindsRoom) {
  for (int aside = -3; aside <= 3; ++aside) {
    for (const double behind : {2.0, 3.0}) {
      for (const double faster : {1.3, 1.6}) {
        const Outcome outcome =
            drive_eteb({{{-behind, 0.2 * aside}, [=](double) { return Vector2(faster, 0.0); }}}, kFast, 25.0);
        EXPECT_GT(outcome.smallest_gap, 0.0)
            << "from " << -behind << " " << 0.2 * aside << " with " << faster;
        EXPECT_TRUE(outcome.reached);
      }
    }
  }
}

/// Along x, and from `begin` on within 0.6 s back, in the direction `back`.
Gait turning_round(double begin, const Vector2& back) {
  return [=](double time) {
    const double share = std::clamp((time - begin) / 0.6, 0.0, 1.0);
    return Vector2(kWalking * ((1.0 - share) * Vector2(1.0, 0.0) + share * back.normalized()));
  };
}

// Somebody overtakes a base of 0.6 m/s (Eddie's limits), turns round before it and comes back towards its
// lane, as people do at the end of their path.
TEST(FromAllSides, OneWhoTurnsRoundBeforeASlowRobot) {
  const Limits eddie{.v_max = 0.6,
                     .v_back_max = 0.4,
                     .omega_max = 1.5,
                     .acc_max = 0.8,
                     .alpha_max = 1.5,
                     .jerk_max = 4.0,
                     .stop_deceleration = 1.5};
  const auto contacts = [&](double assumed_pedestrian_speed) {
    PlannerOptions options;
    options.of<teb::PredictionOptions>("eteb").assumed_pedestrian_speed = assumed_pedestrian_speed;
    int count = 0;
    for (const double aside : {0.4, 0.7, 1.0, 1.3}) {
      for (const double ahead : {0.8, 1.2, 1.6, 2.0}) {
        const double begin = (ahead + 1.0) / (kWalking - eddie.v_max);
        const std::vector<Walker> walkers = {{{-1.0, aside}, turning_round(begin, {-ahead, -aside - 0.2})}};
        count += drive_eteb(walkers, eddie.v_max, begin + 5.0, eddie, options).smallest_gap < 0.0 ? 1 : 0;
      }
    }
    return count;
  };
  const int with_the_room_of_fast_ones = contacts(0.0);
  const int with_more = contacts(teb::default_eteb_prediction().assumed_pedestrian_speed);
  EXPECT_LT(with_more, with_the_room_of_fast_ones);  // 8 and 12
  test::expect_at_most("contacts of a slow robot with one who turns round, of 16",
                       {.asked = 0, .measured = 8}, with_more);
}

// A line of people crosses before the robot, which has to wait; one more comes over the position where it
// waits.
TEST(FromAllSides, TheWaitingRobotMakesRoom) {
  int contacts = 0;
  for (const double x_crossing : {0.2, 0.6, 1.0}) {
    for (const double arrival : {4.0, 6.0}) {
      std::vector<Walker> walkers;
      for (int i = 0; i < 12; ++i)
        walkers.push_back({{2.0, -1.1 * i}, [](double) { return Vector2(0.0, 1.2); }});
      walkers.push_back({{x_crossing, 1.2 * arrival}, [](double) { return Vector2(0.0, -1.2); }});
      const Outcome outcome = drive_eteb(walkers, 0.0, 30.0);
      contacts += outcome.smallest_gap <= 0.0 ? 1 : 0;
      EXPECT_GT(outcome.smallest_gap, -0.03) << "at " << x_crossing << " m after " << arrival << " s";
      EXPECT_TRUE(outcome.reached);
    }
  }
  EXPECT_EQ(contacts, 0);
}

}  // namespace
}  // namespace bw
