// Whom the robot obeys, in real time and in two processes: outsiders are participants of their own, as ROS 2
// nodes are. What moves is the true robot. How long an outsider tries: 1 s each, BANDWAGON_FOREIGN_SECONDS
// asks for more.
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <limits>

#include <gmock/gmock.h>

#include "tests/faults/outside_driver.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using geometry_msgs::msg::Twist;
using geometry_msgs::msg::TwistStamped;
using std::chrono::microseconds;
using testing::HasSubstr;
using testing::Not;

constexpr microseconds k20Hz{50'000}, k50Hz{20'000}, k1kHz{1'000};
constexpr double kStill = 0.005;  // [m]: 0.00

double foreign_seconds() {
  const char* text = std::getenv("BANDWAGON_FOREIGN_SECONDS");
  return text != nullptr ? std::max(1.0, std::atof(text)) : 1.0;
}

class WhoCommands : public testing::Test {
 protected:
  static std::unique_ptr<Process> start(const std::string& process) {
    return std::make_unique<Process>(std::vector<std::string>{
        BANDWAGON_PROGRAM, "run", BANDWAGON_SOURCE_DIR "/tests/faults/commanded.yaml", "--only", process,
        "--for", "600"});
  }
  void SetUp() override { ASSERT_TRUE(spectator_.sees_it_stand()) << base_->err(); }
  void TearDown() override {
    for (const auto& process : {safety_.get(), base_.get()}) {
      process->signal(SIGINT);
      EXPECT_EQ(process->wait(std::chrono::seconds(20)), 0) << process->err();
    }
  }
  bool base_logs(const std::string& text) {
    return eventually([&] { return base_->err().find(text) != std::string::npos; });
  }
  /// Somebody on cmd_vel moves nothing.
  void expect_refused(const std::string& name, microseconds period, double v) {
    const OutsideDriver<Twist> intruder(name, "cmd_vel", period, [v] { return twist(v); });
    const double moved = spectator_.moves_within(foreign_seconds());
    std::printf("%s: %d commands of %.1f m/s, the robot moved %.3f m\n", name.c_str(), intruder.sent(), v,
                moved);
    EXPECT_LT(moved, kStill) << name;
    EXPECT_FALSE(intruder.is_heard()) << name;
    EXPECT_TRUE(base_logs("refused: /cmd_vel is commanded by /collision_monitor alone; /" + name +
                          " publishes it too; others are heard on /cmd_vel_teleop, /cmd_vel_nav"))
        << base_->err();
  }

  /// When the first zero from now on was written.
  std::optional<Time> command_of_zero() {
    const auto reader = witness_.create_reader(ros_end<Twist>("cmd_vel", Qos::standard(100)), [] {});
    dds::Sample sample;
    const bool came = eventually([&] {
      for (Twist command; reader->take(sample) && deserialize(sample.cdr, command);) {
        if (command == Twist{}) return true;
      }
      return false;
    });
    return came ? std::optional(sample.sent) : std::nullopt;
  }

  dds::Participant witness_{{.network = dds::Network::from_environment({})}};
  Spectator spectator_;
  std::unique_ptr<Process> base_ = start("base");
  std::unique_ptr<Process> safety_ = start("safety");
};

TEST_F(WhoCommands, AForeignCommandMovesNothingBeforeAndAfterTheFirstOfTheOwner) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  expect_refused("before", k50Hz, 1.0);
  expect_refused("before_fast", k1kHz, 1.0);
  {
    const OutsideDriver<Twist> planner("planner", "cmd_vel_nav", k20Hz, [] { return twist(0.5); });
    EXPECT_TRUE(spectator_.sees([](const auto& sight) { return sight.x > 0.3; }));
  }
  ASSERT_TRUE(spectator_.sees_it_stand());
  expect_refused("after", k50Hz, 1.0);
  expect_refused("after_fast", k1kHz, 1.0);
  expect_refused("after_nan", k1kHz, kNan);
  // Nor does anybody disturb the owner.
  const OutsideDriver<Twist> intruder("meanwhile", "cmd_vel", k1kHz, [] { return twist(-1.0); });
  const OutsideDriver<Twist> planner("planner", "cmd_vel_nav", k20Hz, [] { return twist(0.5); });
  EXPECT_TRUE(spectator_.sees([](const auto& sight) { return sight.x > 1.0; }));
}

TEST_F(WhoCommands, TheHandDrivesUntilTheWallAndNotALongerWhileThanItSpeaks) {
  // Before the planner, who wants to go back meanwhile.
  {
    const OutsideDriver<Twist> planner("planner", "cmd_vel_nav", k20Hz, [] { return twist(-0.3); });
    OutsideDriver<Twist> hand("teleop", "cmd_vel_teleop", k20Hz, [] { return twist(0.5); });
    EXPECT_TRUE(spectator_.sees([](const auto& sight) { return sight.x > 0.5 && sight.v > 0.4; }));
    hand.stop();
    const auto stopped = command_of_zero();
    ASSERT_TRUE(stopped.has_value());
    std::printf("the hand ends: cmd_vel is zero %.0f ms after its last command\n",
                (*stopped - hand.last()).to_seconds() * 1e3);
  }
  ASSERT_TRUE(spectator_.sees_it_stand());
  EXPECT_LT(spectator_.moves_within(0.5), kStill);
  // A joystick that is held keeps going forward: the monitor stops the robot, 0.3 m of radius before the wall
  // at 4 m.
  const OutsideDriver<TwistStamped> joystick("joystick", "cmd_vel_teleop_stamped", k20Hz, [] {
    TwistStamped message;
    message.header().stamp(to_stamp(system_time()));
    message.twist(twist(0.8));
    return message;
  });
  EXPECT_TRUE(spectator_.sees([](const auto& sight) { return sight.x > 1.5; }));
  ASSERT_TRUE(spectator_.sees_it_stand());
  EXPECT_LT(spectator_.moves_within(1.0), 0.02);
  const double gap = 4.0 - 0.3 - spectator_.look()->x;
  std::printf("driven by hand at 0.8 m/s, the robot stands %.2f m before the wall\n", gap);
  EXPECT_GT(gap, 0.05);
  EXPECT_LT(gap, 0.5);
}

TEST_F(WhoCommands, AnOwnerThatWasKilledAndStartedAgainIsObeyedWhileTheOldOneIsRemembered) {
  const OutsideDriver<Twist> hand("teleop", "cmd_vel_teleop", k20Hz, [] { return twist(0.2); });
  EXPECT_TRUE(spectator_.sees([](const auto& sight) { return sight.v > 0.15; }));
  safety_->signal(SIGKILL);
  ASSERT_TRUE(safety_->wait(std::chrono::seconds(20)).has_value());
  safety_ = start("safety");
  ASSERT_TRUE(spectator_.sees_it_stand());
  EXPECT_TRUE(spectator_.sees([](const auto& sight) { return sight.v > 0.15; })) << safety_->err();
  EXPECT_THAT(base_->err(), Not(HasSubstr("nobody is obeyed")));
}

}  // namespace
}  // namespace bw::test
