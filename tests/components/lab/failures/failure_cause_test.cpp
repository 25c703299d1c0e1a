// Causes of failures whose answers are known.
#include "components/lab/failures/failure_cause.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace bw {
namespace {

/// 20 s at `speed` along x, looked at ten times a second; person 4 where `position_at` says, from `appears`
/// on.
RunRecording straight_drive(double speed, const std::function<Vector2(double)>& position_at,
                            double appears = 0.0) {
  RunRecording drive;
  drive.robot = Footprint{0.3, {}};
  for (int i = 0; i <= 200; ++i) {
    const double t = 0.1 * i;
    RecordedMoment moment{.time = t, .X_MB = {speed * t, 0.0, 0.0}};
    if (position_at && t >= appears - 1e-9) moment.people.push_back({4, position_at(t), {0.0, 0.0}, 0.3});
    drive.moments.push_back(std::move(moment));
  }
  return drive;
}

ContactRecord contact(double time, WhoHit who) {
  ContactRecord record;
  record.time = time;
  record.person = 4;
  record.closing.who = who;
  return record;
}

Vector2 straight(double t) { return {10.0 - t, 0.0}; }
/// To the left from 9 s on.
Vector2 around_a_corner(double t) { return t < 9.0 ? straight(t) : Vector2(1.0, t - 9.0); }

// Straight on from 8 s on they would be at (0, 0) after 10 s, and are at (1, 1).
TEST(FailureCause, WhoTurnedIsTheCauseUnlessTheRobotClosedIn) {
  const FoundCause found =
      cause_of(straight_drive(0.0, around_a_corner), contact(10.0, WhoHit::robot_standing), true);
  EXPECT_EQ(found.cause, FailureCause::turning_walker);
  EXPECT_NEAR(*found.off_course, std::sqrt(2.0), 1e-9);
  EXPECT_EQ(cause_of(straight_drive(0.0, around_a_corner), contact(10.0, WhoHit::robot_closing), true).cause,
            FailureCause::robot_closing);
  // 0.2 s after the turn: 0.28 m, less than their radius.
  EXPECT_EQ(cause_of(straight_drive(0.0, around_a_corner), contact(9.2, WhoHit::person_side), true).cause,
            FailureCause::from_side);
}

TEST(FailureCause, WhoWentStraightOnIsToldByWhoHitWhom) {
  const RunRecording drive = straight_drive(0.0, straight);
  const auto by = [&](WhoHit who) { return cause_of(drive, contact(10.0, who), true).cause; };
  EXPECT_EQ(by(WhoHit::robot_standing), FailureCause::robot_standing);
  EXPECT_EQ(by(WhoHit::person_side), FailureCause::from_side);
  EXPECT_EQ(by(WhoHit::person_behind), FailureCause::from_behind);
  EXPECT_EQ(by(WhoHit::person_ahead), FailureCause::from_ahead);
  EXPECT_NEAR(*cause_of(drive, contact(10.0, WhoHit::person_side), true).off_course, 0.0, 1e-9);
}

TEST(FailureCause, RecordingsThatBeginOrEndInMidFloorStandApart) {
  ContactRecord record = contact(10.0, WhoHit::robot_closing);
  record.begins_mid_floor = true;
  record.there_since = 9.8;
  const FoundCause found = cause_of(straight_drive(0.0, straight, 9.8), record, true);
  EXPECT_EQ(found.cause, FailureCause::mid_floor);
  EXPECT_FALSE(found.off_course.has_value()) << "not seen for long enough to head anywhere";
  record.begins_mid_floor = false;
  record.ends_mid_floor = true;
  EXPECT_EQ(cause_of(straight_drive(0.0, straight), record, true).cause, FailureCause::mid_floor);
}

// They came at 8.35 s, between two moments, and turned at 9 s: straight on from 8.8 s on they would be at (0,
// 0) after 10 s.
TEST(FailureCause, WhoCameLaterIsHeldAgainstTheirFirstSteps) {
  ContactRecord record = contact(10.0, WhoHit::person_side);
  record.there_since = 8.35;
  const FoundCause found = cause_of(straight_drive(0.0, around_a_corner, 8.4), record, true);
  EXPECT_EQ(found.cause, FailureCause::turning_walker);
  EXPECT_NEAR(*found.off_course, std::sqrt(2.0), 1e-9);
}

// 0.04 m/s for 10 s are 0.4 m.
TEST(FailureCause, WithoutAContactItWasLateOrStuckOrTouchedAThing) {
  EXPECT_EQ(cause_of(straight_drive(0.5, {}), std::nullopt, false).cause, FailureCause::late);
  EXPECT_EQ(cause_of(straight_drive(0.04, {}), std::nullopt, false).cause, FailureCause::stuck);
  EXPECT_EQ(cause_of(straight_drive(0.5, {}), std::nullopt, true).cause, FailureCause::thing);
  // A pillar has a number, and is nobody.
  EXPECT_EQ(cause_of(straight_drive(0.5, {}), contact(3.0, WhoHit::robot_closing), true).cause,
            FailureCause::thing);
}

}  // namespace
}  // namespace bw
