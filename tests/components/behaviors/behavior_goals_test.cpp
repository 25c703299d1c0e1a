// Goals that are none: one terminal state at the first step, with the code of Nav2 and a sentence, and
// nothing moves.
#include "components/behaviors/behavior_goals.hpp"

#include <limits>

#include <gmock/gmock.h>

namespace bw {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

BehaviorStep first_step(Behavior& behavior) {
  BehaviorSituation situation;
  situation.problem.now = Time::seconds(10.0);
  return behavior.step(situation);
}

BehaviorStep drive(const Vector2& target, double z, double speed, const Limits& limits = {}) {
  return first_step(
      *make_drive_on_heading({.target = target, .target_z = z, .speed = speed}, {}, limits, {}));
}
BehaviorStep back_up(const Vector2& target, double z, double speed, const Limits& limits = {}) {
  return first_step(*make_back_up({.target = target, .target_z = z, .speed = speed}, {}, limits, {}));
}

void expect_refused(const BehaviorStep& step, BehaviorError error, const std::string& text) {
  EXPECT_EQ(step.state, BehaviorStep::State::failed);
  EXPECT_EQ(step.error, error);
  EXPECT_EQ(step.text, text);
  EXPECT_EQ(step.command, std::nullopt);
}

TEST(BehaviorGoals, DriveOnHeadingRefusesWhatItCannotDo) {
  const auto invalid = BehaviorError::invalid_input;
  const std::string only_x = "target.y and target.z must be 0: only x is driven";
  expect_refused(drive({0.3, 0.1}, 0.0, 0.1), invalid, only_x);
  expect_refused(drive({0.3, 0.0}, -0.1, 0.1), invalid, only_x);
  const std::string sign = "target.x and speed must have the same sign";
  expect_refused(drive({0.3, 0.0}, 0.0, -0.1), invalid, sign);
  expect_refused(drive({-0.3, 0.0}, 0.0, 0.1), invalid, sign);
  expect_refused(drive({0.3, 0.0}, 0.0, 0.0), invalid, sign);
  expect_refused(drive({0.0, 0.0}, 0.0, 0.1), invalid, sign);  // Nav2's rule: 0 counts as negative
  expect_refused(drive({-0.3, 0.0}, 0.0, 0.0), invalid, "the speed must not be 0");
  for (const double none : {kNoNumber, kInfinity, -kInfinity}) {
    expect_refused(drive({none, 0.0}, 0.0, 0.1), invalid, "the target is not finite");
    expect_refused(drive({0.3, none}, 0.0, 0.1), invalid, "the target is not finite");
    expect_refused(drive({0.3, 0.0}, none, 0.1), invalid, "the target is not finite");
    expect_refused(drive({0.3, 0.0}, 0.0, none), invalid, "the speed is not finite");
  }
  Limits forward;
  forward.v_back_max = 0.0;
  expect_refused(drive({-0.3, 0.0}, 0.0, -0.1, forward), invalid, "the base does not drive backwards");
}

TEST(BehaviorGoals, BackupRefusesTheSameButForSigns) {
  const auto invalid = BehaviorError::invalid_input;
  expect_refused(back_up({0.3, 0.1}, 0.0, 0.1), invalid, "target.y and target.z must be 0: only x is driven");
  expect_refused(back_up({kNoNumber, 0.0}, 0.0, 0.1), invalid, "the target is not finite");
  expect_refused(back_up({0.3, 0.0}, 0.0, kNoNumber), invalid, "the speed is not finite");
  expect_refused(back_up({0.3, 0.0}, 0.0, 0.0), invalid, "the speed must not be 0");
  Limits forward;
  forward.v_back_max = 0.0;
  expect_refused(back_up({0.3, 0.0}, 0.0, 0.1, forward), invalid, "the base does not drive backwards");
}

TEST(BehaviorGoals, SpinRefusesWhatIsNoAngle) {
  for (const double none : {kNoNumber, kInfinity, -kInfinity})
    expect_refused(first_step(*make_spin({.target_yaw = none}, {}, {})), BehaviorError::unknown,
                   "target_yaw is not finite");
}

TEST(BehaviorGoals, NothingToDoIsDoneAtOnce) {
  EXPECT_EQ(drive({0.0, 0.0}, 0.0, 0.0).state, BehaviorStep::State::succeeded);
  EXPECT_EQ(back_up({0.0, 0.0}, 0.0, 0.1).state, BehaviorStep::State::succeeded);
  EXPECT_EQ(first_step(*make_spin({}, {}, {})).state, BehaviorStep::State::succeeded);
}

TEST(BehaviorOptions, RulesOverSeveral) {
  EXPECT_EQ(BehaviorOptions{}.violated_rule(), std::nullopt);
  BehaviorOptions slow;
  slow.min_rotational_vel = 2.0;
  EXPECT_EQ(slow.violated_rule(), "min_rotational_vel must be at most max_rotational_vel");
  BehaviorOptions rare;
  rare.cycle_frequency = 2.0;
  EXPECT_EQ(rare.violated_rule(), "command_lead must be at least half of the time between two commands");
}

}  // namespace
}  // namespace bw
