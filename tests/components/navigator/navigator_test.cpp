#include "components/navigator/navigator.hpp"

#include <algorithm>
#include <functional>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw {
namespace {

using ::testing::HasSubstr;

/// A robot on a line with planners that answer as told. Steps of 50 ms.
class Drive {
 public:
  explicit Drive(const NavigatorOptions& options = {}) : navigator(options) {}

  Situation situation() const {
    return {now, lost ? std::nullopt : std::optional(Pose2{x, 0.0, 0.0}), {v, 0.0}};
  }

  /// Sends what the navigator wants sent; planners answer at once through it.
  void exchange() {
    for (int guard = 0; guard < 20; ++guard) {
      const NavigatorActions actions = navigator.step(situation());
      for (const GoalReport& report : actions.reports) reports.push_back(report);
      if (actions.follow) {
        orders.push_back(*actions.follow);
        v = 0.0;
        if (actions.follow->mode == FollowMode::follow) v = speed;
        if (actions.follow->mode == FollowMode::back_off) v = -0.1;
      }
      if (!actions.plan) return;
      plans.push_back(*actions.plan);
      plan_times.push_back(now);
      if (answer_plans)
        navigator.on_plan({actions.plan->id, outcome, outcome_reason, path(actions.plan->X_MG)}, situation());
    }
    FAIL() << "the navigator orders without end";
  }

  std::vector<Pose2> path(const Pose2& X_MG) const {
    if (outcome != PlanOutcome::succeeded || empty_plans) return {};
    return {{x, 0, 0}, X_MG};
  }

  std::uint64_t go_through(std::vector<Pose2> via, double goal) {
    goal_x = goal;
    const std::uint64_t id = navigator.accept({{goal, 0, 0}, std::move(via)}, situation());
    exchange();
    return id;
  }
  std::size_t poses_remaining() const { return navigator.report(situation()).poses_remaining; }

  void run(double seconds) {
    const Time end = now + Duration::seconds(seconds);
    while (now < end) {
      now = now + Duration::milliseconds(50);
      if (follow_state == FollowState::blocked && v > 0.0) v = 0.0;
      x += v * 0.05;
      if (goal_x && v > 0.0 && x >= *goal_x) {
        x = *goal_x;
        v = 0.0;
      }
      if (report_follow && !orders.empty()) {
        navigator.on_follow({orders.back().id, follow_state, "two people in the way", error_code},
                            situation());
      }
      exchange();
    }
  }

  std::uint64_t go_to(double goal) {
    goal_x = goal;
    const std::uint64_t id = navigator.accept({goal, 0, 0}, situation());
    exchange();
    return id;
  }

  int count(FollowMode mode) const {
    return static_cast<int>(
        std::count_if(orders.begin(), orders.end(), [mode](const FollowOrder& o) { return o.mode == mode; }));
  }
  const GoalReport& last() const { return reports.back(); }

  Navigator navigator;
  Time now = Time::seconds(100.0);
  double x = 0.0;
  double v = 0.0;
  double speed = 1.0;
  bool lost = false;
  std::optional<double> goal_x;
  bool answer_plans = true;
  bool empty_plans = false;
  bool report_follow = true;
  PlanOutcome outcome = PlanOutcome::succeeded;
  std::string outcome_reason;
  FollowState follow_state = FollowState::following;
  std::uint16_t error_code = 0;  ///< of the reports
  std::vector<GoalReport> reports;
  std::vector<FollowOrder> orders;
  std::vector<PlanOrder> plans;
  std::vector<Time> plan_times;
};

std::vector<GoalStatus> statuses(const std::vector<GoalReport>& reports, std::uint64_t goal) {
  std::vector<GoalStatus> list;
  for (const GoalReport& report : reports) {
    if (report.goal_id == goal) list.push_back(report.status);
  }
  return list;
}

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
  for (int block = 0; block < 10; ++block) {  // ten blocks with 2 m of way between them: never six in a row
    drive.follow_state = FollowState::blocked;
    drive.run(6.0);
    drive.follow_state = FollowState::following;
    drive.run(4.5);
  }
  drive.run(60.0);
  EXPECT_EQ(drive.last().status, GoalStatus::succeeded);
  EXPECT_EQ(drive.last().recoveries, 10U);
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

// An hour back in the middle of a drive: plans are renewed as before, silence is noticed as before, and the time of the
// drive counts what passed.
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

// Via poses at 3 and 6 m on the way to 10 m, at 1 m/s: passed at 2.3 and 5.3 m, 0.7 m before them.
TEST(Navigator, DrivesThroughPosesWithoutAStop) {
  Drive drive;
  drive.go_through({{3, 0, 0}, {6, 0, 0}}, 10.0);
  EXPECT_EQ(drive.plans.front().via.size(), 2U);
  std::vector<double> passed_at;
  std::size_t remaining = 3;
  while (drive.navigator.has_goal() && drive.x < 9.9) {
    drive.run(0.05);
    if (drive.poses_remaining() == remaining) continue;
    remaining = drive.poses_remaining();
    passed_at.push_back(drive.x);
  }
  EXPECT_THAT(passed_at,
              ::testing::ElementsAre(::testing::DoubleNear(2.3, 0.051), ::testing::DoubleNear(5.3, 0.051)));
  EXPECT_EQ(drive.count(FollowMode::stop), 0);
  EXPECT_THAT(drive.plans.back().via, ::testing::IsEmpty());
  drive.run(1.0);
  EXPECT_EQ(drive.last().status, GoalStatus::succeeded);
  EXPECT_NEAR(drive.last().navigation_time.to_seconds(), 10.0, 0.11);
}

TEST(Navigator, PosesArePassedInTheirOrder) {
  Drive drive;
  drive.go_through({{8, 0, 0}, {2, 0, 0}}, 10.0);
  drive.run(4.0);  // past the second, whose turn it is not
  EXPECT_EQ(drive.poses_remaining(), 3U);
  drive.run(4.0);
  EXPECT_EQ(drive.poses_remaining(), 2U);
}

TEST(Navigator, AGoalWhereTheRobotStandsIsReachedOnlyThroughItsPoses) {
  Drive drive;
  const std::uint64_t id = drive.go_through({{5, 0, 0}}, 0.0);
  drive.goal_x.reset();
  drive.run(3.0);
  EXPECT_TRUE(drive.navigator.has_goal());
  drive.run(1.5);
  EXPECT_EQ(drive.poses_remaining(), 1U);
  drive.speed = -1.0;
  while (drive.x > 0.2) drive.run(0.05);
  drive.v = drive.speed = 0.0;
  drive.run(0.05);
  EXPECT_EQ(drive.last().goal_id, id);
  EXPECT_EQ(drive.last().status, GoalStatus::succeeded);
}

// 4 m out and back again: at 1 m on the way out 3 m and 4 m are left, on the way back 1 m.
TEST(Navigator, DistanceRemainingKnowsWhichStretchIsDriven) {
  std::vector<Pose2> path;
  for (int i = 0; i <= 40; ++i) path.push_back({0.1 * i, 0, 0});
  for (int i = 39; i >= 0; --i) path.push_back({0.1 * i, 0, 0});
  EXPECT_NEAR(remaining_length(path, {1.0, 0.0}, {{4, 0, 0}}), 7.0, 1e-9);
  EXPECT_NEAR(remaining_length({path.begin() + 40, path.end()}, {1.0, 0.0}), 1.0, 1e-9);
  EXPECT_NEAR(straight_length({0, 0}, {{4, 0, 0}, {4, 3, 0}}, {0, 0, 0}), 4.0 + 3.0 + 5.0, 1e-9);
}

TEST(Navigator, TracksItsPathWithTheSignsOfNav2) {
  const std::vector<Pose2> path = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const TrackingError error = tracking_error(path, {1.2, 0.3, 0.1});
  EXPECT_NEAR(error.position, 0.3, 1e-12);
  EXPECT_NEAR(error.heading, -0.1, 1e-12);
  EXPECT_NEAR(tracking_error(path, {2.5, -0.2, 0.0}).position, -0.2, 1e-12);
  EXPECT_NEAR(tracking_error({{1, 1, 1.5}}, {1, 1, 1.0}).heading, 0.5, 1e-12);
}

TEST(Navigator, TimeRemainingIsThatOfTheSpeedOfNow) {
  EXPECT_NEAR(time_remaining(3.0, {0.5, 0.0}).to_seconds(), 6.0, 1e-9);
  EXPECT_EQ(time_remaining(3.0, {0.009, 0.0}), Duration{});
  EXPECT_EQ(time_remaining(0.09, {0.5, 0.0}), Duration{});
}

TEST(Navigator, TellsProgramsWhyAGoalWasNotReached) {
  const std::pair<PlanOutcome, GoalFault> outcomes[] = {
      {PlanOutcome::start_blocked, GoalFault::start_blocked},
      {PlanOutcome::goal_blocked, GoalFault::goal_blocked},
      {PlanOutcome::disconnected, GoalFault::no_path},
      {PlanOutcome::no_map, GoalFault::planner_failed},
      {PlanOutcome::bad_request, GoalFault::planner_failed},
      {PlanOutcome::failed, GoalFault::planner_failed}};
  for (const auto& [outcome, fault] : outcomes) {
    Drive drive;
    drive.outcome = outcome;
    drive.go_to(10.0);
    drive.run(60.0);
    EXPECT_EQ(drive.last().status, GoalStatus::aborted);
    EXPECT_EQ(drive.last().fault, fault);
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
