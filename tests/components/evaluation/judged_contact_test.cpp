// Contacts of recorded drives, judged: two drives whose answers are known.
#include "components/evaluation/judged_contact.hpp"

#include <gtest/gtest.h>

#include "components/evaluation/success.hpp"

namespace bw {
namespace {

using possible::Avoidance;

/// 1 m/s along x, looked at 50 times a second; somebody stands at (4, 0) from `appears` on. Contact at 3.4 m.
RunRecorder drive_at_somebody(double appears) {
  RunRecorder recorder({0.3, {}}, 1.0);
  recorder.set_limits({});
  recorder.start(Time::seconds(10.0), {8.0, 0.0});
  for (int k = 0; k <= 400; ++k) {
    const double t = 0.02 * k;
    TruthSample sample;
    sample.time = Time::seconds(10.0 + t);
    sample.X_MB = {t, 0.0, 0.0};
    sample.twist = {1.0, 0.0};
    if (t >= appears - 1e-9) sample.people.push_back({3, {4.0, 0.0}, {0.0, 0.0}, 0.3});
    recorder.add(sample);
  }
  return recorder;
}

TEST(JudgedContact, WhoWasThereCouldBeAvoided) {
  const RunRecorder recorder = drive_at_somebody(0.0);
  const std::vector<JudgedContact> judged = judge_contacts(recorder.recording());
  ASSERT_EQ(judged.size(), 1U);
  EXPECT_NEAR(judged[0].record.time, 3.4, 0.021);
  EXPECT_EQ(judged[0].record.closing.who, WhoHit::robot_closing);
  EXPECT_TRUE(judged[0].is_judged);
  EXPECT_EQ(judged[0].verdict.avoidance, Avoidance::avoidable);
  // Braking at 1 m/s^2 takes 0.5 m.
  EXPECT_NEAR(*judged[0].verdict.saveable_until, 2.9, 0.15);
  EXPECT_FALSE(is_excused(judged, 1));
}

// 0.1 m ahead of the rim: braking takes 0.5 m, and 0.25 m with twice the deceleration.
TEST(JudgedContact, WhoAppearsInMidFloorCouldNot) {
  const RunRecorder recorder = drive_at_somebody(3.3);
  const std::vector<JudgedContact> judged = judge_contacts(recorder.recording());
  ASSERT_EQ(judged.size(), 1U);
  EXPECT_TRUE(judged[0].record.begins_mid_floor);
  EXPECT_EQ(judged[0].verdict.avoidance, Avoidance::not_avoidable);
  EXPECT_TRUE(is_excused(judged, 1));
  EXPECT_FALSE(is_excused(judged, 2));  // a wall besides
}

TEST(JudgedContact, WithoutLimitsNothingIsJudged) {
  RunRecording recording = drive_at_somebody(3.3).recording();
  recording.limits.reset();
  const std::vector<JudgedContact> judged = judge_contacts(recording);
  ASSERT_EQ(judged.size(), 1U);
  EXPECT_FALSE(judged[0].is_judged);
  EXPECT_FALSE(is_excused(judged, 1));
}

// Success is one thing (success.hpp): the contact of a robot that stands counts as any other, for failure and
// for excuse.
TEST(JudgedContact, AStandingRobotsContactsCountAsAllOthers) {
  JudgedContact stood;
  stood.is_judged = true;
  stood.verdict.avoidance = Avoidance::not_avoidable;
  EXPECT_TRUE(is_excused({stood}, 1));
  EXPECT_FALSE(is_excused({}, 0));
  EXPECT_FALSE(is_success(true, 1));
  EXPECT_FALSE(is_success(false, 0));
  EXPECT_TRUE(is_success(true, 0));
}

}  // namespace
}  // namespace bw
