// When a goal of follow_path is over. Figures are those of the nav2_params.yaml that Nav2 ships: 0.25 m and
// 0.25 rad, 0.5 m in 10 s, 0.3 s without a motion, 0.3 s without an input.
#include "components/local_planner/follow_path/follow_judge.hpp"

#include <gtest/gtest.h>

namespace bw {
namespace {

/// A cycle each 0.1 s from 100 s on, 5 m before the goal and moving, unless a test says otherwise.
struct Drive {
  FollowJudge judge;
  FollowPathOptions options;
  FollowCycle cycle{.now = Time{100'000'000'000},
                    .missing = "",
                    .unknown_pose = "",
                    .X_OB = {},
                    .X_OG = {5.0, 0.0, 0.0},
                    .distance_to_goal = 5.0,
                    .is_on_last_leg = true,
                    .travelled = 0.0,
                    .twist = {0.5, 0.0},
                    .status = PlanningStatus::ok,
                    .reason = ""};

  FollowVerdict next() {
    const FollowVerdict verdict = judge.judge(cycle, options);
    cycle.now = cycle.now + Duration::milliseconds(100);
    return verdict;
  }
  /// Cycles until it is over, the last one included; 0: it is not within `most`.
  int cycles_to_end(int most = 1000, FollowVerdict* end = nullptr) {
    for (int i = 1; i <= most; ++i) {
      const FollowVerdict verdict = next();
      if (end != nullptr) *end = verdict;
      if (verdict.is_over) return i;
    }
    return 0;
  }
  void stand_at(double distance, double heading) {
    cycle.X_OB = {5.0 - distance, 0.0, heading};
    cycle.distance_to_goal = distance;
    cycle.twist = {};
  }
};

TEST(FollowJudge, IsThereWithinBothTolerancesAndStanding) {
  Drive d;
  EXPECT_FALSE(d.next().is_over);
  d.stand_at(0.26, 0.0);
  EXPECT_FALSE(d.next().is_over);
  d.stand_at(0.24, 0.26);
  EXPECT_FALSE(d.next().is_over);
  d.stand_at(0.24, -0.24);
  d.cycle.twist = {0.06, 0.0};
  EXPECT_FALSE(d.next().is_over);
  d.cycle.twist = {0.0, 0.11};
  EXPECT_FALSE(d.next().is_over);
  d.cycle.twist = {0.05, -0.1};
  const FollowVerdict end = d.next();
  EXPECT_TRUE(end.is_over);
  EXPECT_EQ(end.failure.fault, FollowFault::none);
}

TEST(FollowJudge, WhoTremblesAtTheGoalIsThereOnceItSettled) {
  Drive d;
  d.stand_at(0.1, 0.0);
  d.cycle.twist = {0.2, 0.0};
  EXPECT_EQ(d.cycles_to_end(), 16);  // 1.5 s after the first
}

TEST(FollowJudge, AWayThatEndsWhereItBeginsIsDriven) {
  Drive d;
  d.stand_at(0.1, 0.0);
  d.cycle.distance_to_goal = 8.0;
  EXPECT_FALSE(d.next().is_over);
  d.cycle.distance_to_goal = 0.9;
  d.cycle.is_on_last_leg = false;
  EXPECT_FALSE(d.next().is_over) << "it turns back once more before the goal";
  d.cycle.is_on_last_leg = true;
  EXPECT_TRUE(d.next().is_over);
}

TEST(FollowJudge, ProgressIsHalfAMetreInTenSeconds) {
  Drive d;
  FollowVerdict end;
  d.cycle.reason = "somebody is in the way";
  EXPECT_EQ(d.cycles_to_end(1000, &end), 102);  // 10 s after the first is still in time
  EXPECT_EQ(end.failure.fault, FollowFault::failed_to_make_progress);
  EXPECT_EQ(end.failure.reason, "no progress: less than 0.5 m in 10 s; somebody is in the way");

  Drive charging;  // it may go on by itself, and is waited for
  charging.cycle.base_stop = BaseStop{.reason = "the charger is plugged in"};
  EXPECT_EQ(charging.cycles_to_end(1000, &end), 102);
  EXPECT_EQ(end.failure.reason,
            "no progress: less than 0.5 m in 10 s; the base stands: the charger is plugged in");

  Drive moving;
  moving.cycles_to_end(90);
  moving.cycle.travelled = 0.5;
  EXPECT_EQ(moving.cycles_to_end(), 102);

  Drive to_and_fro;  // half a metre each second, and nowhere
  int cycles = 0;
  for (bool over = false; !over && cycles < 1000; ++cycles) {
    to_and_fro.cycle.X_OB.x = cycles / 10 % 2 == 0 ? 0.0 : 0.6;
    over = to_and_fro.next().is_over;
  }
  EXPECT_EQ(cycles, 102);

  Drive unchecked;
  unchecked.options.progress_checker_plugins.clear();
  EXPECT_EQ(unchecked.cycles_to_end(), 0);
}

TEST(FollowJudge, PatienceWithoutAWay) {
  Drive d;
  EXPECT_FALSE(d.next().is_over);
  d.cycle.status = PlanningStatus::infeasible;
  d.cycle.reason = "no free motion";
  FollowVerdict end;
  EXPECT_EQ(d.cycles_to_end(10, &end), 4);  // 0.1, 0.2, 0.3 s since the last that was free, then more
  EXPECT_EQ(end.failure.fault, FollowFault::patience_exceeded);
  EXPECT_EQ(end.failure.reason, "no free motion; no way for more than 0.3 s");

  Drive at_once;
  at_once.options.failure_tolerance = 0.0;
  at_once.cycle.status = PlanningStatus::infeasible;
  EXPECT_EQ(at_once.cycles_to_end(10, &end), 1);
  EXPECT_EQ(end.failure.fault, FollowFault::no_valid_control);

  Drive never;
  never.options.failure_tolerance = -1.0;
  never.cycle.status = PlanningStatus::infeasible;
  EXPECT_EQ(never.cycles_to_end(1000, &end), 102);
  EXPECT_EQ(end.failure.fault, FollowFault::failed_to_make_progress);

  Drive now_and_then;
  for (int i = 0; i < 50; ++i) {
    now_and_then.cycle.status = i % 3 == 0 ? PlanningStatus::ok : PlanningStatus::infeasible;
    EXPECT_FALSE(now_and_then.next().is_over) << i;
  }
}

TEST(FollowJudge, WhatIsMissingIsWaitedForAndThenNamed) {
  Drive d;
  EXPECT_FALSE(d.next().is_over);
  d.cycle.missing = "a needed input is stale";
  FollowVerdict end;
  EXPECT_EQ(d.cycles_to_end(10, &end), 4);  // 0.3 s after the first without
  EXPECT_EQ(end.failure.fault, FollowFault::controller_timed_out);
  EXPECT_EQ(end.failure.reason, "a needed input is stale");

  Drive lost;
  lost.cycle.unknown_pose = "no transform from map to odom";
  EXPECT_EQ(lost.cycles_to_end(10, &end), 4);
  EXPECT_EQ(end.failure.fault, FollowFault::tf_error);
  EXPECT_EQ(end.failure.reason, "no transform from map to odom");

  Drive back;
  for (int i = 0; i < 20; ++i) {
    back.cycle.missing = i % 4 == 3 ? "" : "a needed input is stale";
    EXPECT_FALSE(back.next().is_over) << i;
  }
}

TEST(FollowJudge, AClockThatGoesBackBeginsAnew) {
  Drive d;
  d.cycles_to_end(95);
  d.cycle.now = Time{1'000'000'000};
  EXPECT_EQ(d.cycles_to_end(), 102);
}

}  // namespace
}  // namespace bw
