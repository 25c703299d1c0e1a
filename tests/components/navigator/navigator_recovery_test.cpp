// What the navigator does when the drive does not go on: it waits, backs off, gives up, and always ends.
#include <algorithm>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "tests/components/navigator/navigator_drive.hpp"

namespace bw {
namespace {

using ::testing::HasSubstr;

TEST(Navigator, BlockedForGoodWaitsBacksOffAndGivesUpWithTheReason) {
  Drive drive;
  drive.go_to(10.0);
  drive.run(2.0);
  drive.follow_state = FollowState::blocked;
  drive.run(120.0);
  EXPECT_EQ(drive.last().status, GoalStatus::aborted);
  EXPECT_THAT(drive.last().reason, HasSubstr("two people in the way"));
  EXPECT_THAT(drive.last().reason, HasSubstr("gave up after 6 recoveries"));
  EXPECT_EQ(drive.last().recoveries, 6U);
  EXPECT_EQ(drive.count(FollowMode::back_off), 3);
  EXPECT_EQ(drive.orders.back().mode, FollowMode::stop);
  EXPECT_EQ(drive.v, 0.0);
}

TEST(Navigator, BlockedForAWhileGoesOnAndForgetsItsRecoveries) {
  Drive drive;
  drive.go_to(40.0);
  for (int block = 0; block < 10; ++block) {  // ten blocks, 2 m of travel between them: never six in a row
    drive.follow_state = FollowState::blocked;
    drive.run(6.0);
    drive.follow_state = FollowState::following;
    drive.run(4.5);
  }
  drive.run(60.0);
  EXPECT_EQ(drive.last().status, GoalStatus::succeeded);
  EXPECT_EQ(drive.last().recoveries, 10U);
}

// Ten minutes: it neither goes on nor is given up for want of progress, and says what it waits for.
TEST(Navigator, AGoalThatAHandInterruptedWaitsUntilItIsReleased) {
  Drive drive;
  const std::uint64_t goal = drive.go_to(10.0);
  drive.run(2.0);
  const double x = drive.x;
  drive.is_overridden = true;
  drive.run(600.0);
  EXPECT_LE(drive.x, x + 0.05);
  EXPECT_EQ(drive.orders.back().mode, FollowMode::stop);
  EXPECT_EQ(drive.last().goal_id, goal);
  EXPECT_EQ(drive.last().status, GoalStatus::executing);
  EXPECT_EQ(drive.last().reason, "interrupted by a hand: goes on after release_stop");
  EXPECT_EQ(drive.last().recoveries, 0U);
  drive.x = -3.0;  // where the hand left it
  drive.is_overridden = false;
  drive.run(60.0);
  EXPECT_EQ(drive.last().goal_id, goal);
  EXPECT_EQ(drive.last().status, GoalStatus::succeeded);
}

TEST(Navigator, AGoalThatAHandInterruptedIsCanceledOrPreemptedAsEver) {
  Drive drive;
  drive.go_to(10.0);
  drive.run(1.0);
  drive.is_overridden = true;
  drive.run(1.0);
  const std::uint64_t other = drive.go_to(5.0);
  drive.run(1.0);
  EXPECT_EQ(drive.orders.back().mode, FollowMode::stop);  // the hand is still there
  drive.is_overridden = false;
  drive.run(1.0);
  EXPECT_EQ(drive.orders.back().mode, FollowMode::follow);
  EXPECT_EQ(drive.last().goal_id, other);
  drive.is_overridden = true;
  drive.run(1.0);
  drive.navigator.cancel(drive.situation());
  drive.run(1.0);
  EXPECT_EQ(drive.last().status, GoalStatus::canceled);
  drive.is_overridden = false;
  drive.run(5.0);
  EXPECT_EQ(drive.orders.back().mode, FollowMode::stop);
}

// The base touches something 2 m on its way and takes a release, which comes after ten minutes: the goal
// neither fails nor ends, and its status says why with the next step, 0.05 s later. The order to follow
// stays, so that the base knows that it will drive on.
TEST(Navigator, AGoalWaitsWhileTheBaseStandsAndSaysWhy) {
  Drive drive;
  const std::uint64_t goal = drive.go_to(10.0);
  drive.run(2.0);
  const std::size_t orders = drive.orders.size();
  drive.base_stop = {"bumper: left", true};
  drive.run(0.05);
  EXPECT_EQ(drive.last().status, GoalStatus::executing);
  EXPECT_EQ(drive.last().reason, "waiting: the base stands: bumper: left; until release_stop");
  drive.follow_state = FollowState::blocked;  // a planner that gets nowhere
  drive.run(600.0);
  EXPECT_EQ(drive.last().goal_id, goal);
  EXPECT_EQ(drive.last().reason, "waiting: the base stands: bumper: left; until release_stop");
  EXPECT_EQ(drive.navigator.report(drive.situation()).recoveries, 0U);
  for (std::size_t i = orders; i < drive.orders.size(); ++i)
    ASSERT_EQ(drive.orders[i].mode, FollowMode::follow);
  drive.base_stop.reset();
  drive.follow_state = FollowState::following;
  drive.run(0.05);
  EXPECT_EQ(drive.last().reason, "");
  drive.v = drive.speed;
  drive.run(20.0);
  EXPECT_EQ(drive.last().goal_id, goal);
  EXPECT_EQ(drive.last().status, GoalStatus::succeeded);
}

// What the base says changes: each is told once.
TEST(Navigator, AGoalThatWaitsForTheBaseTellsEachReasonOnce) {
  Drive drive;
  drive.go_to(10.0);
  drive.run(1.0);
  drive.reports.clear();
  drive.base_stop = {"the base is silent", false};
  drive.run(1.0);
  drive.base_stop = {"the base is silent", true};
  drive.run(1.0);
  drive.base_stop.reset();
  drive.run(0.05);
  ASSERT_EQ(drive.reports.size(), 3U);
  EXPECT_EQ(drive.reports[0].reason, "waiting: the base stands: the base is silent");
  EXPECT_EQ(drive.reports[1].reason, "waiting: the base stands: the base is silent; until release_stop");
  EXPECT_EQ(drive.reports[2].reason, "");
}

// Refused with the base's reason; one that takes the place of a goal in hand is not.
TEST(Navigator, AGoalIsHinderedByABaseThatStandsUnlessAnotherWaits) {
  Navigator navigator{NavigatorOptions{}};
  Situation situation{.now = Time::seconds(100.0), .X_MB = Pose2{}};
  EXPECT_EQ(navigator.hindrance(situation).fault, GoalFault::none);
  situation.base_stop = BaseStop{"the charger is connected", false};
  const GoalProblem problem = navigator.hindrance(situation);
  EXPECT_EQ(problem.fault, GoalFault::base_stands);
  EXPECT_EQ(problem.reason, "the base stands: the charger is connected");
  navigator.accept({{10.0, 0.0, 0.0}, {}}, situation);
  EXPECT_EQ(navigator.hindrance(situation).fault, GoalFault::none);
}

// A newer goal takes the place of one that waits, and waits likewise: after the release nobody drives to the
// older one.
TEST(Navigator, AGoalThatWaitsForTheBaseIsPreemptedOrCanceledAsEver) {
  Drive drive;
  drive.go_to(10.0);
  drive.run(1.0);
  drive.base_stop = {"bumper: left", true};
  drive.run(1.0);
  const std::uint64_t other = drive.go_to(5.0);
  drive.run(1.0);
  EXPECT_EQ(drive.last().goal_id, other);
  EXPECT_EQ(drive.last().reason, "waiting: the base stands: bumper: left; until release_stop");
  EXPECT_EQ(drive.orders.back().path.back().x, 5.0);
  drive.navigator.cancel(drive.situation());
  drive.run(1.0);
  EXPECT_EQ(drive.last().status, GoalStatus::canceled);
  drive.base_stop.reset();
  drive.run(5.0);
  EXPECT_EQ(drive.orders.back().mode, FollowMode::stop);
}

TEST(Navigator, BackingOffEndsAfterItsDistance) {
  Drive drive;
  drive.go_to(10.0);
  drive.run(3.0);
  drive.follow_state = FollowState::blocked;
  drive.run(0.05);
  const double stuck_at = drive.x;
  while (drive.count(FollowMode::back_off) == 0) drive.run(0.05);
  drive.follow_state = FollowState::following;
  while (drive.orders.back().mode == FollowMode::back_off) drive.run(0.05);
  EXPECT_NEAR(drive.x, stuck_at - 0.3, 0.02);
}

TEST(Navigator, NoProgressIsARecovery) {
  Drive drive;
  drive.speed = 0.02;  // 0.2 m in 10 s; 0.3 m are asked for
  drive.go_to(10.0);
  drive.run(9.9);
  EXPECT_EQ(drive.count(FollowMode::stop), 0);
  drive.run(0.3);
  EXPECT_EQ(drive.orders.back().mode, FollowMode::stop);
  EXPECT_THAT(drive.last().reason, HasSubstr("no progress"));
}

TEST(Navigator, TurningOnTheSpotIsProgress) {
  NavigatorOptions options;
  ProgressChecker checker;
  for (int i = 0; i < 300; ++i) {
    const Time now = Time::seconds(0.1 * i);
    EXPECT_TRUE(checker.update(now, {0.0, 0.0, wrap_angle(0.06 * 0.1 * i * 10.0)}, options.progress()));
  }
}

TEST(Navigator, ASilentLocalPlannerIsNoticed) {
  Drive drive;
  drive.go_to(30.0);
  drive.run(2.0);
  drive.report_follow = false;
  drive.speed = 0.0;
  drive.run(2.3);
  EXPECT_THAT(drive.last().reason, HasSubstr("the local planner does not answer"));
  EXPECT_EQ(drive.last().status, GoalStatus::executing);
}

// An hour back in the middle of a drive: plans are renewed as before, silence is noticed as before, and the
// time of the drive counts what passed.
TEST(Navigator, AClockThatGoesBackDelaysNothing) {
  Drive drive;
  drive.now = Time::seconds(7200.0);
  drive.go_to(30.0);
  drive.run(2.0);
  const std::size_t plans = drive.plans.size();
  drive.now = Time::seconds(3600.0);
  drive.run(3.0);
  EXPECT_NEAR(static_cast<double>(drive.plans.size() - plans), 3.0, 1.0);
  drive.report_follow = false;
  drive.speed = 0.0;
  drive.run(2.3);
  EXPECT_THAT(drive.last().reason, HasSubstr("the local planner does not answer"));
  EXPECT_NEAR(drive.last().navigation_time.to_seconds(), 6.0, 1.35);
}

TEST(Navigator, ASilentGlobalPlannerIsNoticed) {
  Drive drive;
  drive.answer_plans = false;
  drive.go_to(10.0);
  drive.run(2.2);
  EXPECT_THAT(drive.last().reason, HasSubstr("the global planner does not answer"));
  drive.run(60.0);
  EXPECT_EQ(drive.last().status, GoalStatus::aborted);
}

TEST(Navigator, ABlockedStartIsBackedOutOf) {
  Drive drive;
  drive.outcome = PlanOutcome::start_blocked;
  drive.go_to(10.0);
  EXPECT_EQ(drive.orders.back().mode, FollowMode::back_off);
  drive.run(2.0);
  drive.outcome = PlanOutcome::succeeded;
  drive.run(20.0);
  EXPECT_EQ(drive.last().status, GoalStatus::succeeded);
}

// xy_tolerance of 0.2 m and 0.1 m that a judge adds: 0.3 m. Nobody knows that it is there who knows it to 0.31 m.
TEST(Navigator, ClaimsNoGoalThatItDoesNotKnowItIsAt) {
  Drive drive;
  drive.go_to(2.0);
  drive.two_sigma = 0.31;
  drive.run(11.0);  // 2 s of driving, 9 of 10 s of waiting
  EXPECT_EQ(drive.last().status, GoalStatus::executing);
  EXPECT_EQ(drive.v, 0.0);
  drive.two_sigma = 0.29;  // the next fix
  drive.run(0.1);
  EXPECT_EQ(drive.last().status, GoalStatus::succeeded);

  drive.go_to(4.0);
  drive.two_sigma = 0.31;
  drive.run(13.0);
  EXPECT_EQ(drive.last().status, GoalStatus::aborted);
  EXPECT_EQ(drive.last().fault, GoalFault::unplaced);
  EXPECT_THAT(drive.last().reason, HasSubstr("does not know"));
}

TEST(Navigator, LostRobotStopsAndGoesOnOrGivesUp) {
  Drive drive;
  drive.go_to(10.0);
  drive.run(2.0);
  drive.lost = true;
  drive.run(0.1);
  EXPECT_EQ(drive.orders.back().mode, FollowMode::stop);
  drive.lost = false;
  drive.run(2.0);
  EXPECT_EQ(drive.orders.back().mode, FollowMode::follow);
  drive.lost = true;
  drive.run(10.5);
  EXPECT_EQ(drive.last().status, GoalStatus::aborted);
  EXPECT_THAT(drive.last().reason, HasSubstr("does not know where it is"));
}

TEST(Navigator, EveryGoalEndsExactlyOnceWhateverHappens) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    Drive drive;
    std::uint64_t goals = 0;
    for (int event = 0; event < 60; ++event) {
      const double dice = random.uniform();
      if (dice < 0.15) {
        drive.go_to(random.uniform(-5.0, 20.0));
        ++goals;
      } else if (dice < 0.2) {
        drive.go_through({{random.uniform(-5.0, 20.0), 0, 0}}, random.uniform(-5.0, 20.0));
        ++goals;
      } else if (dice < 0.3) {
        drive.navigator.cancel(drive.situation());
        drive.exchange();
      } else if (dice < 0.5) {
        drive.follow_state = static_cast<FollowState>(static_cast<int>(random.uniform(0.0, 5.0)));
      } else if (dice < 0.6) {
        drive.outcome = static_cast<PlanOutcome>(static_cast<int>(random.uniform(0.0, 7.0)));
      } else if (dice < 0.65) {
        drive.lost = !drive.lost;
      } else if (dice < 0.7) {
        drive.report_follow = !drive.report_follow;
      } else if (dice < 0.75) {
        drive.answer_plans = !drive.answer_plans;
      }
      drive.run(random.uniform(0.05, 5.0));
      if (::testing::Test::HasFatalFailure()) return;
      if (!drive.navigator.has_goal()) {
        ASSERT_TRUE(drive.orders.empty() || drive.orders.back().mode == FollowMode::stop) << "seed " << seed;
      }
    }
    drive.follow_state = FollowState::blocked;
    drive.run(600.0);
    ASSERT_FALSE(drive.navigator.has_goal()) << "seed " << seed;
    for (std::uint64_t id = 1; id <= goals; ++id) {
      const std::vector<GoalStatus> list = statuses(drive.reports, id);
      ASSERT_EQ(std::count_if(list.begin(), list.end(), is_final), 1) << "goal " << id << " seed " << seed;
      ASSERT_TRUE(is_final(list.back())) << "goal " << id << " seed " << seed;
    }
    for (const GoalReport& report : drive.reports) {
      if (is_final(report.status)) {
        ASSERT_FALSE(report.reason.empty()) << "seed " << seed;
      }
    }
  }
}

}  // namespace
}  // namespace bw
