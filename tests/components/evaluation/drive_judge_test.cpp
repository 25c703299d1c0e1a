#include "components/evaluation/drive_judge.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace bw {
namespace {

Time at(double seconds) { return Time::seconds(10.0 + seconds); }

class Drive {
 public:
  explicit Drive(DriveJudge::Lasts lasts = DriveJudge::Lasts::until_goal)
      : judge({}, {0.3, {}}, 1.0, lasts) {}

  DriveJudge judge;

  /// Along x at 1 m/s; the robot believes to be 0.1 m to the left.
  void drive(double from_s, double to_s, double x_at_start) {
    for (double t = from_s; t <= to_s + 1e-9; t += 0.1) {
      TruthSample sample;
      sample.time = at(t);
      sample.X_MB = {x_at_start + t - from_s, 0.0, 0.0};
      sample.twist = {1.0, 0.0};
      sample.wall_gap = 2.0;
      judge.on_truth(sample);
      judge.on_pose(sample.time, {sample.X_MB.x, 0.1, 0.0});
    }
  }
  bool goal(std::uint64_t id, double x, bool is_over, bool is_claimed, bool others_follow, double t) {
    return judge.on_goal({.goal_id = id,
                          .is_over = is_over,
                          .is_claimed = is_claimed,
                          .others_follow = others_follow,
                          .reason = is_claimed ? "reached" : "blocked",
                          .goal = {x, 0.0}},
                         at(t));
  }
};

// Nobody drives: everything from the beginning on is scored, and no goal is reached or missed.
TEST(DriveJudge, ARunWithoutAGoalIsScoredWhole) {
  Drive d;
  d.judge.begin_run(at(0.0));
  d.drive(0.0, 2.0, 0.0);
  TruthSample position{
      .time = at(2.5), .X_MB = {3.0, 0.0, std::nan("")}, .twist = {std::nan(""), std::nan("")}};
  d.judge.on_truth(position);
  d.judge.end_run(at(2.5));
  const ScoreCard& card = d.judge.card();
  EXPECT_TRUE(card.finished);
  EXPECT_FALSE(card.reached);
  EXPECT_NEAR(card.path_length, 3.0, 1e-9);
  EXPECT_TRUE(std::isnan(card.distance_to_goal));
  EXPECT_NEAR(d.judge.pose_errors().mean_position(), 0.1, 1e-12);
  EXPECT_TRUE(d.judge.recorder().recording().goals.empty());
  EXPECT_NEAR(d.judge.recorder().recording().moments.back().speed, 2.0, 1e-6);  // 1 m in half a second
  EXPECT_FALSE(d.judge.running());
}

// 3 m to the first goal, 2 s at it, 1 m to the second, which is canceled half a metre short; then a goal in a
// wall is refused while the robot stands, and the run ends: one card of 4 m in 8 s with the last outcome.
TEST(DriveJudge, AWholeRunHasTheOutcomeOfItsLastGoal) {
  Drive d(DriveJudge::Lasts::until_end_of_run);
  EXPECT_FALSE(d.goal(1, 3.0, false, false, false, 0.0));
  d.drive(0.0, 3.0, 0.0);
  EXPECT_TRUE(d.goal(1, 3.0, true, true, false, 3.0));
  EXPECT_TRUE(d.judge.running());
  EXPECT_TRUE(d.judge.card().reached);
  EXPECT_EQ(d.judge.card().reason, "reached");

  EXPECT_FALSE(d.goal(2, 4.5, false, false, false, 5.0));
  EXPECT_FALSE(d.judge.card().reached);
  EXPECT_TRUE(d.judge.has_goal());
  EXPECT_FALSE(d.goal(3, 9.0, true, false, false, 5.5));  // refused while the second is driven
  d.drive(5.0, 6.0, 3.0);
  EXPECT_TRUE(d.goal(2, 4.5, true, false, false, 6.0));
  EXPECT_EQ(d.judge.card().reason, "blocked");

  EXPECT_TRUE(d.goal(4, 9.0, true, false, false, 7.0));
  d.drive(8.0, 8.0, 4.0);
  d.judge.end_run(at(8.0));
  const ScoreCard& card = d.judge.card();
  EXPECT_TRUE(card.finished);
  EXPECT_FALSE(card.reached);
  EXPECT_EQ(card.reason, "blocked");
  EXPECT_NEAR(card.path_length, 4.0, 1e-9);
  EXPECT_NEAR(card.time_to_goal, 8.0, 1e-9);
  EXPECT_FALSE(d.judge.running());
}

TEST(DriveJudge, AWholeRunThatEndsBeforeItsGoalDidNotReachIt) {
  Drive d(DriveJudge::Lasts::until_end_of_run);
  d.goal(1, 3.0, false, false, false, 0.0);
  d.drive(0.0, 1.0, 0.0);
  d.judge.end_run(at(1.0));
  EXPECT_FALSE(d.judge.card().reached);
  EXPECT_EQ(d.judge.card().reason, "the run ended before its goal");
}

// Two goals, 3 m and 4 m farther: one card of 7 m in 7 s.
TEST(DriveJudge, SeveralGoalsAreOneDrive) {
  Drive d;
  EXPECT_FALSE(d.goal(1, 3.0, false, false, true, 0.0));
  d.drive(0.0, 3.0, 0.0);
  EXPECT_FALSE(d.goal(1, 3.0, true, true, true, 3.0));
  EXPECT_TRUE(d.judge.running());
  EXPECT_FALSE(d.goal(2, 7.0, false, false, false, 3.0));
  d.drive(3.0, 7.0, 3.0);
  EXPECT_TRUE(d.goal(2, 7.0, true, true, false, 7.0));
  const ScoreCard& card = d.judge.card();
  EXPECT_TRUE(card.finished && card.reached);
  EXPECT_NEAR(card.time_to_goal, 7.0, 1e-9);
  EXPECT_NEAR(card.path_length, 7.0, 1e-9);
  EXPECT_NEAR(d.judge.pose_errors().rms_position(), 0.1, 1e-9);
  EXPECT_EQ(d.judge.recorder().recording().goals.size(), 2U);
}

// The first goal is missed by 1 m or given up; the second is reached: the drive is not.
TEST(DriveJudge, EveryGoalOfTheDriveCounts) {
  for (const bool is_claimed : {true, false}) {
    Drive d;
    d.goal(1, 4.0, false, false, true, 0.0);
    d.drive(0.0, 3.0, 0.0);
    d.goal(1, 4.0, true, is_claimed, true, 3.0);
    d.goal(2, 7.0, false, false, false, 3.0);
    d.drive(3.0, 7.0, 3.0);
    EXPECT_TRUE(d.goal(2, 7.0, true, true, false, 7.0));
    EXPECT_TRUE(d.judge.card().finished);
    EXPECT_FALSE(d.judge.card().reached);
    EXPECT_EQ(d.judge.card().reason, "an earlier goal was not reached");
  }
}

TEST(DriveJudge, ANewDriveBeginsAFreshCard) {
  Drive d;
  d.goal(1, 3.0, false, false, false, 0.0);
  d.drive(0.0, 3.0, 0.0);
  EXPECT_TRUE(d.goal(1, 3.0, true, true, false, 3.0));
  EXPECT_FALSE(d.goal(1, 3.0, true, true, false, 3.1)) << "told twice";
  d.goal(2, 5.0, false, false, false, 4.0);
  EXPECT_EQ(d.judge.card().path_length, 0.0);
  EXPECT_EQ(d.judge.recorder().recording().goals.size(), 1U);
}

}  // namespace
}  // namespace bw
