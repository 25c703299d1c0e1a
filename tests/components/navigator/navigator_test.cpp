// Goals: reached, renewed, preempted, cancelled, and what the planners answer.
#include <limits>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/components/navigator/navigator_drive.hpp"

namespace bw {
namespace {

using ::testing::HasSubstr;

TEST(Navigator, ReachesAGoalAndSaysSo) {
  Drive drive;
  const std::uint64_t id = drive.go_to(5.0);
  drive.run(10.0);
  EXPECT_THAT(statuses(drive.reports, id),
              ::testing::ElementsAre(GoalStatus::accepted, GoalStatus::executing, GoalStatus::succeeded));
  EXPECT_EQ(drive.last().reason, "reached");
  EXPECT_NEAR(drive.last().navigation_time.to_seconds(), 5.0, 0.11);  // 5 m at 1 m/s
  EXPECT_EQ(drive.orders.back().mode, FollowMode::stop);
  EXPECT_FALSE(drive.navigator.has_goal());
  EXPECT_EQ(drive.last().recoveries, 0U);
}

TEST(Navigator, ReplansOncePerSecondWhileDriving) {
  Drive drive;
  drive.go_to(20.0);
  drive.run(10.2);
  EXPECT_EQ(drive.plans.size(), 11U);  // the first and one each second
  for (std::size_t i = 1; i < drive.plan_times.size(); ++i) {
    EXPECT_NEAR((drive.plan_times[i] - drive.plan_times[i - 1]).to_seconds(), 1.0, 0.051);
  }
}

TEST(Navigator, ReplansAtOnceWhenBlocked) {
  Drive drive;
  drive.go_to(20.0);
  drive.run(1.5);  // the last plan is about 0.5 s old
  const std::size_t before = drive.plans.size();
  drive.follow_state = FollowState::blocked;
  drive.run(0.1);
  EXPECT_EQ(drive.plans.size(), before + 1);
}

TEST(Navigator, DistanceRemainingFollowsThePath) {
  Drive drive;
  drive.go_to(10.0);
  drive.run(4.0);
  EXPECT_NEAR(drive.navigator.report(drive.situation()).distance_remaining, 6.0, 0.06);
  EXPECT_NEAR(remaining_length({{0, 0, 0}, {1, 0, 0}, {1, 2, 0}}, {0.1, 0.0}), 0.9 + 2.0, 1e-12);
  EXPECT_EQ(remaining_length({}, {0.0, 0.0}), 0.0);
}

TEST(Navigator, ANewerGoalPreempts) {
  Drive drive;
  const std::uint64_t first = drive.go_to(10.0);
  drive.run(2.0);
  const std::size_t orders_before = drive.orders.size();
  const std::uint64_t second = drive.go_to(4.0);
  EXPECT_EQ(statuses(drive.reports, first).back(), GoalStatus::aborted);
  const auto ended = std::find_if(drive.reports.begin(), drive.reports.end(), [&](const GoalReport& report) {
    return report.goal_id == first && report.status == GoalStatus::aborted;
  });
  EXPECT_EQ(ended->reason, "preempted by goal " + std::to_string(second));
  for (std::size_t i = orders_before; i < drive.orders.size(); ++i) {
    EXPECT_EQ(drive.orders[i].mode, FollowMode::follow) << "a sound drive is not interrupted by a newer goal";
  }
  drive.run(5.0);
  EXPECT_EQ(drive.last().goal_id, second);
  EXPECT_EQ(drive.last().status, GoalStatus::succeeded);
}

TEST(Navigator, CancelStopsFirstThenReports) {
  Drive drive;
  const std::uint64_t id = drive.go_to(10.0);
  drive.run(2.0);
  drive.navigator.cancel(drive.situation());  // still at 1 m/s
  NavigatorActions actions = drive.navigator.step(drive.situation());
  ASSERT_TRUE(actions.follow.has_value());
  EXPECT_EQ(actions.follow->mode, FollowMode::stop);
  EXPECT_EQ(actions.reports.back().status, GoalStatus::canceling);
  EXPECT_TRUE(drive.navigator.has_goal());
  drive.v = 0.0;
  actions = drive.navigator.step(drive.situation());
  EXPECT_EQ(actions.reports.back().status, GoalStatus::canceled);
  EXPECT_EQ(actions.reports.back().goal_id, id);
  EXPECT_FALSE(drive.navigator.has_goal());
}

TEST(Navigator, CancelOfARobotThatNeverStandsStillEnds) {
  Drive drive;
  drive.go_to(10.0);
  drive.run(1.0);
  drive.navigator.cancel(drive.situation());
  for (int i = 0; i < 110; ++i) {
    drive.now = drive.now + Duration::milliseconds(50);
    for (const GoalReport& report : drive.navigator.step(drive.situation()).reports)
      drive.reports.push_back(report);
  }
  EXPECT_EQ(drive.last().status, GoalStatus::canceled);
  EXPECT_THAT(drive.last().reason, HasSubstr("does not come to rest"));
}

TEST(Navigator, UnreachableGoalsEndSoonWithThePlannersReason) {
  for (const PlanOutcome outcome : {PlanOutcome::goal_blocked, PlanOutcome::disconnected}) {
    Drive drive;
    drive.outcome = outcome;
    drive.outcome_reason = "the goal lies in a wall";
    drive.go_to(10.0);
    drive.run(5.0);
    EXPECT_EQ(drive.last().status, GoalStatus::aborted);
    EXPECT_EQ(drive.last().reason, "no plan: the goal lies in a wall");
    EXPECT_EQ(drive.plans.size(), 3U);
    EXPECT_EQ(drive.count(FollowMode::back_off), 0);
  }
}

TEST(Navigator, ABadRequestEndsAtOnce) {
  Drive drive;
  drive.outcome = PlanOutcome::bad_request;
  drive.go_to(10.0);
  EXPECT_EQ(drive.last().status, GoalStatus::aborted);
}

TEST(Navigator, WaitsForAMapWithoutDriving) {
  Drive drive;
  drive.outcome = PlanOutcome::no_map;
  drive.go_to(5.0);
  drive.run(4.0);
  EXPECT_EQ(drive.x, 0.0);
  drive.outcome = PlanOutcome::succeeded;
  drive.run(10.0);
  EXPECT_EQ(drive.last().status, GoalStatus::succeeded);
}

TEST(Navigator, AnEmptyPlanIsNoPlan) {
  Drive drive;
  drive.empty_plans = true;
  drive.go_to(5.0);
  EXPECT_THAT(drive.last().reason, HasSubstr("the plan is empty"));
  EXPECT_EQ(drive.count(FollowMode::follow), 0);
}

TEST(Navigator, AFailedReplanKeepsTheGoodPath) {
  Drive drive;
  drive.go_to(10.0);
  drive.run(2.0);
  drive.outcome = PlanOutcome::disconnected;
  drive.run(3.0);
  EXPECT_NEAR(drive.x, 5.0, 0.1);
  EXPECT_EQ(drive.orders.back().mode, FollowMode::follow);
}

TEST(Navigator, AnswersToOlderOrdersAreIgnored) {
  Drive drive;
  drive.answer_plans = false;
  drive.go_to(10.0);
  const std::uint64_t old_plan = drive.plans.back().id;
  drive.go_to(4.0);
  drive.navigator.on_plan({old_plan, PlanOutcome::succeeded, "", {{0, 0, 0}, {10, 0, 0}}}, drive.situation());
  drive.exchange();
  EXPECT_EQ(drive.count(FollowMode::follow), 0);
  drive.navigator.on_plan({drive.plans.back().id, PlanOutcome::succeeded, "", {{0, 0, 0}, {4, 0, 0}}},
                          drive.situation());
  drive.exchange();
  EXPECT_EQ(drive.count(FollowMode::follow), 1);
  const std::uint64_t current = drive.orders.back().id;
  drive.navigator.on_follow({current - 1, FollowState::failed, "old"}, drive.situation());
  drive.exchange();
  EXPECT_EQ(drive.orders.back().id, current);
}

TEST(Navigator, ToleranceIsEnoughWhenThePlannerNeverSettles) {
  Drive drive;
  drive.speed = 0.06;  // creeps about the goal above stopped_speed
  drive.go_to(5.0);
  drive.x = 4.85;
  drive.goal_x = 1e9;
  drive.run(1.4);
  EXPECT_TRUE(drive.navigator.has_goal());
  drive.run(0.4);
  EXPECT_EQ(drive.last().status, GoalStatus::succeeded);
}

TEST(Navigator, PassingThroughTheGoalIsNotArriving) {
  Drive drive;
  drive.go_to(5.0);
  drive.goal_x = 7.0;  // the robot overshoots by 2 m
  drive.run(8.0);
  EXPECT_TRUE(drive.navigator.has_goal());
  EXPECT_EQ(drive.last().status, GoalStatus::executing);
}

TEST(Navigator, AGoalThatIsNotFiniteIsAbortedAndPreemptsNothing) {
  Drive drive;
  const std::uint64_t good = drive.go_to(5.0);
  const std::uint64_t bad =
      drive.navigator.accept({std::numeric_limits<double>::quiet_NaN(), 0, 0}, drive.situation());
  EXPECT_EQ(bad, good + 1);
  drive.exchange();
  EXPECT_EQ(drive.last().goal_id, bad);
  EXPECT_EQ(drive.last().status, GoalStatus::aborted);
  drive.run(10.0);
  EXPECT_EQ(drive.last().goal_id, good);
  EXPECT_EQ(drive.last().status, GoalStatus::succeeded);
}

TEST(Navigator, TellsProgramsWhyAGoalWasNotReached) {
  for (const PlanOutcome outcome :
       {PlanOutcome::start_blocked, PlanOutcome::goal_blocked, PlanOutcome::disconnected, PlanOutcome::no_map,
        PlanOutcome::bad_request, PlanOutcome::failed}) {
    Drive drive;
    drive.outcome = outcome;
    drive.plan_error_code = 204;
    drive.go_to(10.0);
    drive.run(60.0);
    EXPECT_EQ(drive.last().status, GoalStatus::aborted);
    EXPECT_EQ(drive.last().fault, GoalFault::planner_failed);
    EXPECT_EQ(drive.last().error_code, 204) << "the code of the planner comes along";
  }
  const std::pair<FollowState, GoalFault> states[] = {{FollowState::blocked, GoalFault::blocked},
                                                      {FollowState::failed, GoalFault::controller_failed}};
  for (const auto& [state, fault] : states) {
    Drive drive;
    drive.speed = 0.0;
    drive.go_to(10.0);
    drive.follow_state = state;
    drive.error_code = 104;
    drive.run(120.0);
    EXPECT_EQ(drive.last().status, GoalStatus::aborted);
    EXPECT_EQ(drive.last().fault, fault);
    EXPECT_EQ(drive.last().error_code, 104) << "the code of the server below comes along";
  }
  Drive preempted;
  preempted.go_to(10.0);
  preempted.go_to(5.0);
  EXPECT_THAT(preempted.reports, ::testing::Contains(::testing::AllOf(
                                     ::testing::Field(&GoalReport::status, GoalStatus::aborted),
                                     ::testing::Field(&GoalReport::fault, GoalFault::preempted))));
  EXPECT_EQ(preempted.navigator.report(preempted.situation()).fault, GoalFault::none);
}

// A report of the local planner asks for another plan, and the same step finds the robot at its goal.
TEST(Navigator, AsksForNoPlanThatNobodyWaitsFor) {
  Navigator navigator{NavigatorOptions{}};
  const auto at = [](double t, double x) { return Situation{Time::seconds(t), Pose2{x, 0.0, 0.0}, {}}; };
  navigator.accept({{1.0, 0.0, 0.0}, {}}, at(100.0, 0.0));
  const std::uint64_t plan = navigator.step(at(100.0, 0.0)).plan->id;
  navigator.on_plan({.id = plan, .path = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}}, at(100.0, 0.0));
  const std::uint64_t order = navigator.step(at(100.0, 0.0)).follow->id;
  navigator.on_follow({.id = order, .state = FollowState::blocked, .reason = "a wall"}, at(101.0, 1.0));
  const NavigatorActions actions = navigator.step(at(101.0, 1.0));
  ASSERT_FALSE(actions.reports.empty());
  EXPECT_EQ(actions.reports.back().status, GoalStatus::succeeded);
  EXPECT_FALSE(actions.plan.has_value());
}

}  // namespace
}  // namespace bw
