// `bandwagon teleop` on a terminal: what keys become on the wire, what is shown, and how it ends.
#include <bandwagon_msgs/msg/base_state.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <gmock/gmock.h>
#include <nav_msgs/msg/odometry.hpp>
#include <std_msgs/msg/bool.hpp>
#include <termios.h>

#include "runtime/ros/typed_topic.hpp"
#include "tests/interop/on_terminal.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using geometry_msgs::msg::Twist;
using testing::HasSubstr;
namespace base = bandwagon_msgs::msg::BaseState_Constants;

dds::ParticipantOptions local() {
  return {.network = dds::Network::from_environment(dds::Transport::localhost)};
}

/// A terminal with teleop, and a robot that hears it.
class Teleop : public testing::Test {
 protected:
  // Discovery of the one end says nothing of the other's: the robot tells its state until it is shown.
  bool is_ready() {
    return eventually([&] {
      tell(base::WAITING, "");
      const bool is_shown = terminal_.out().find("standing") != std::string::npos;
      return is_shown && commands_.writers() > 0 && emergency_.writers() > 0 && !terminal_.is_ordinary();
    });
  }
  void SetUp() override { ASSERT_TRUE(is_ready()) << terminal_.out(); }
  void tell(std::uint8_t state, const std::string& reason) {
    bandwagon_msgs::msg::BaseState message;
    message.state(state);
    message.reason(reason);
    message.is_latched(state >= base::EMERGENCY_STOP);
    state_.publish(message);
  }
  /// Everything commanded until it is zero after having been something else.
  std::vector<Twist> until_rest() {
    eventually([&] {
      while (auto twist = commands_.take()) heard_.push_back(*twist);
      const auto is_zero = [](const Twist& t) { return t.linear().x() == 0.0 && t.angular().z() == 0.0; };
      return !heard_.empty() && is_zero(heard_.back()) && !is_zero(heard_.front());
    });
    return std::exchange(heard_, {});
  }
  bool is_left_alone() {
    return eventually([&] { return terminal_.is_ordinary(); });
  }

  dds::Participant participant_{local()};
  TopicReader<Twist> commands_{participant_, "/robot1/cmd_vel_teleop", Qos::standard(1000)};
  TopicReader<std_msgs::msg::Bool> emergency_{participant_, "/robot1/emergency_stop", Qos::standard()};
  TopicWriter<bandwagon_msgs::msg::BaseState> state_{participant_, "/robot1/base_state", Qos::standard()};
  TopicWriter<nav_msgs::msg::Odometry> odometry_{participant_, "/robot1/odom", Qos::standard()};
  OnTerminal terminal_{{"teleop", "--v", "0.4", "--omega", "1.0", "--namespace", "robot1"}};
  std::vector<Twist> heard_;
};

// 50 % of 0.4 m/s at 20 Hz for the 200 ms of one key: at 0, 50, 100 and 150 ms; then zero.
TEST_F(Teleop, AKeyDrivesAndSilenceStops) {
  terminal_.press("w");
  std::vector<Twist> driven = until_rest();
  ASSERT_GE(driven.size(), 2U);
  EXPECT_LE(driven.size(), 1U + 5U + 1U) << "no longer than 200 ms: 4, and one at either end";
  EXPECT_DOUBLE_EQ(driven.front().linear().x(), 0.2);
  EXPECT_DOUBLE_EQ(driven.front().angular().z(), 0.0);

  terminal_.press("\x1b[C");  // right, as an arrow
  EXPECT_DOUBLE_EQ(until_rest().front().angular().z(), -0.5);
  terminal_.press("s");
  EXPECT_DOUBLE_EQ(until_rest().front().linear().x(), -0.1);
  terminal_.press("+u");
  const Twist arc = until_rest().front();
  EXPECT_DOUBLE_EQ(arc.linear().x(), 0.24);
  EXPECT_DOUBLE_EQ(arc.angular().z(), 0.6);
}

TEST_F(Teleop, ASpaceStopsAtOnceAndAHeldKeyDrivesOn) {
  for (int i = 0; i < 40; ++i) {  // 2 s of a key that repeats every 50 ms
    terminal_.press("w");
    eventually([&, seen = heard_.size()] {
      while (auto twist = commands_.take()) heard_.push_back(*twist);
      return heard_.size() > seen;
    });
  }
  EXPECT_GE(heard_.size(), 40U) << "20 Hz";
  terminal_.press(" ");
  const std::vector<Twist> all = until_rest();
  EXPECT_DOUBLE_EQ(all.front().linear().x(), 0.2);
}

TEST_F(Teleop, ShowsWhyTheRobotStandsAndStopsItForGood) {
  nav_msgs::msg::Odometry odometry;
  odometry.twist().twist().linear().x(0.17);
  odometry.twist().twist().angular().z(-0.25);
  odometry_.publish(odometry);
  EXPECT_TRUE(terminal_.shows("robot 0.17 m/s -0.25 rad/s")) << terminal_.out();
  terminal_.press("wx");
  EXPECT_TRUE(eventually([&] {
    const auto stop = emergency_.take();
    return stop && stop->data();
  }));
  // A reader of the topic is there; that is no base that stops.
  EXPECT_TRUE(terminal_.shows("NOT STOPPED: base_state tells of no emergency stop")) << terminal_.out();
  EXPECT_TRUE(eventually([&] {
    tell(base::WAITING, "");
    const auto again = emergency_.take();
    return again && again->data();
  }));
  tell(base::EMERGENCY_STOP, "by hand");
  EXPECT_TRUE(terminal_.shows("EMERGENCY STOP: by hand (R releases)")) << terminal_.out();
  EXPECT_TRUE(terminal_.shows("the emergency stop is in force")) << terminal_.out();
  tell(base::BUMPER, "bumper left");
  EXPECT_TRUE(terminal_.shows("STOPPED: bumper left (R releases)")) << terminal_.out();
  // Deliberately: any other key than y is no.
  terminal_.press("R");
  EXPECT_TRUE(terminal_.shows("y releases all stops"));
  terminal_.press("n");
  terminal_.press("y");
  terminal_.press("R");
  terminal_.press("y");
  EXPECT_TRUE(terminal_.shows("nobody offers release_stop")) << terminal_.out();
}

// While a key is down: the last word is zero, and the terminal is as it was.
TEST_F(Teleop, EveryWayOutEndsInAStopAndAnOrdinaryTerminal) {
  terminal_.press("wq");
  EXPECT_EQ(terminal_.status(), 0) << terminal_.out();
  EXPECT_TRUE(is_left_alone());
  until_rest();
}

TEST_F(Teleop, SoDoesCtrlC) {
  terminal_.press("w\x03");
  EXPECT_EQ(terminal_.status(), 0) << terminal_.out();
  EXPECT_TRUE(is_left_alone());
}

TEST_F(Teleop, SoDoASignalAndKeysThatWouldKillOrSuspend) {
  terminal_.press("w\x1c\x1a");  // Ctrl-\ and Ctrl-Z: keys without a meaning
  EXPECT_DOUBLE_EQ(until_rest().front().linear().x(), 0.2);
  terminal_.press("w");
  ASSERT_TRUE(eventually([&] { return commands_.take().has_value(); }));
  terminal_.end();
  EXPECT_EQ(terminal_.status(), 0) << terminal_.out();
  EXPECT_TRUE(is_left_alone());
  EXPECT_DOUBLE_EQ(commands_.take_newest().value().linear().x(), 0.0);
}

TEST_F(Teleop, AWindowThatIsClosedStopsTheRobot) {
  terminal_.press("w");
  ASSERT_TRUE(eventually([&] { return commands_.take().has_value(); }));
  terminal_.hang_up();
  std::optional<Twist> last;
  EXPECT_TRUE(eventually([&] {
    if (auto twist = commands_.take_newest()) last = twist;
    return commands_.writers() == 0;
  })) << "it is gone";
  ASSERT_TRUE(last);
  EXPECT_DOUBLE_EQ(last->linear().x(), 0.0);
}

TEST(TeleopAlone, NeedsATerminal) {
  const Outcome outcome =
      run_to_end({"/bin/sh", "-c", BANDWAGON_PROGRAM " teleop < /dev/null"}, std::chrono::seconds(20));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("needs the keys of a terminal"));
}

}  // namespace
}  // namespace bw::test
