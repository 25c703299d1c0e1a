// The bytes of Spin, BackUp, DriveOnHeading and Wait as navigation2's branches define them. No program of
// Kilted or Lyrical has been met: what is theirs alone is unproved.
#include "components/messages/nav2_layouts.hpp"
#include "tests/components/messages/nav2_golden.hpp"

namespace bw::test {
namespace {

/// float32 target_yaw, Duration time_allowance
template <class Goal>
Goal spin() {
  Goal goal;
  goal.target_yaw(1.57F);
  goal.time_allowance(duration(10));
  return goal;
}
void write_spin(CdrWriter& w) {
  w.floats(1.57);
  write_duration(w, 10);
}

/// Point target, float32 speed, Duration time_allowance: BackUp and DriveOnHeading.
template <class Goal>
Goal drive() {
  Goal goal;
  goal.target(point());
  goal.speed(0.05F);
  goal.time_allowance(duration(10));
  return goal;
}
void write_drive(CdrWriter& w) {
  write_point(w);
  w.floats(0.05);
  write_duration(w, 10);
}

/// From Kilted on, behind either: bool disable_collision_checks
template <class Goal>
Goal unchecked(Goal goal) {
  goal.disable_collision_checks(true);
  return goal;
}
void write_unchecked_spin(CdrWriter& w) {
  write_spin(w);
  w.put<std::uint8_t>(1);
}
void write_unchecked_drive(CdrWriter& w) {
  write_drive(w);
  w.put<std::uint8_t>(1);
}

/// Duration total_elapsed_time
template <class Result>
Golden<Result> elapsed() {
  Result result;
  result.total_elapsed_time(duration(4));
  return {result, [](CdrWriter& w) { write_duration(w, 4); }};
}
/// From Jazzy on behind it: uint16 error_code, string error_msg
template <class Result>
Golden<Result> elapsed(std::uint16_t code) {
  Golden<Result> golden = elapsed<Result>();
  fail(golden.message, code);
  golden.write = [code](CdrWriter& w) {
    write_duration(w, 4);
    write_error(w, code);
  };
  return golden;
}

template <class Feedback>
Golden<Feedback> spun() {
  Feedback feedback;
  feedback.angular_distance_traveled(0.5F);
  return {feedback, [](CdrWriter& w) { w.floats(0.5); }};
}
template <class Feedback>
Golden<Feedback> driven() {
  Feedback feedback;
  feedback.distance_traveled(0.25F);
  return {feedback, [](CdrWriter& w) { w.floats(0.25); }};
}

TEST(Nav2Golden, SpinOfHumble) {
  using Action = HumbleNav2::Spin;
  expect_action<Action>({spin<Action::Goal>(), write_spin}, elapsed<Action::Result>(),
                        spun<Action::Feedback>());
}

TEST(Nav2Golden, SpinOfJazzy) {
  using Action = JazzyNav2::Spin;
  expect_action<Action>({spin<Action::Goal>(), write_spin}, elapsed<Action::Result>(703),
                        spun<Action::Feedback>());
}

TEST(Nav2GoldenUnproved, SpinOfKiltedAndLyrical) {
  using Action = KiltedNav2::Spin;
  EXPECT_TRUE((std::is_same_v<Action, LyricalNav2::Spin>));
  expect_action<Action>({unchecked(spin<Action::Goal>()), write_unchecked_spin}, elapsed<Action::Result>(703),
                        spun<Action::Feedback>());
}

TEST(Nav2Golden, BackUpOfHumble) {
  using Action = HumbleNav2::BackUp;
  expect_action<Action>({drive<Action::Goal>(), write_drive}, elapsed<Action::Result>(),
                        driven<Action::Feedback>());
}

TEST(Nav2Golden, BackUpOfJazzy) {
  using Action = JazzyNav2::BackUp;
  expect_action<Action>({drive<Action::Goal>(), write_drive}, elapsed<Action::Result>(714),
                        driven<Action::Feedback>());
}

TEST(Nav2GoldenUnproved, BackUpOfKiltedAndLyrical) {
  using Action = KiltedNav2::BackUp;
  EXPECT_TRUE((std::is_same_v<Action, LyricalNav2::BackUp>));
  expect_action<Action>({unchecked(drive<Action::Goal>()), write_unchecked_drive},
                        elapsed<Action::Result>(714), driven<Action::Feedback>());
}

TEST(Nav2Golden, DriveOnHeadingOfHumble) {
  using Action = HumbleNav2::DriveOnHeading;
  expect_action<Action>({drive<Action::Goal>(), write_drive}, elapsed<Action::Result>(),
                        driven<Action::Feedback>());
}

TEST(Nav2Golden, DriveOnHeadingOfJazzy) {
  using Action = JazzyNav2::DriveOnHeading;
  expect_action<Action>({drive<Action::Goal>(), write_drive}, elapsed<Action::Result>(724),
                        driven<Action::Feedback>());
}

TEST(Nav2GoldenUnproved, DriveOnHeadingOfKiltedAndLyrical) {
  using Action = KiltedNav2::DriveOnHeading;
  EXPECT_TRUE((std::is_same_v<Action, LyricalNav2::DriveOnHeading>));
  expect_action<Action>({unchecked(drive<Action::Goal>()), write_unchecked_drive},
                        elapsed<Action::Result>(724), driven<Action::Feedback>());
}

template <class Goal>
Golden<Goal> wait() {
  Goal goal;
  goal.time(duration(5));
  return {goal, [](CdrWriter& w) { write_duration(w, 5); }};
}
template <class Feedback>
Golden<Feedback> left() {
  Feedback feedback;
  feedback.time_left(duration(1));
  return {feedback, [](CdrWriter& w) { write_duration(w, 1); }};
}

TEST(Nav2Golden, WaitOfHumble) {
  using Action = HumbleNav2::Wait;
  expect_action<Action>(wait<Action::Goal>(), elapsed<Action::Result>(), left<Action::Feedback>());
}

TEST(Nav2Golden, WaitOfJazzy) {
  using Action = JazzyNav2::Wait;
  expect_action<Action>(wait<Action::Goal>(), elapsed<Action::Result>(741), left<Action::Feedback>());
}

}  // namespace
}  // namespace bw::test
