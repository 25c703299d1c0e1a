// A base in real time behind a cable that this test holds: pulled at random moments at full speed and put
// back, and a planner that falls silent. What is asked: declared, reported, and a decelerating stop on the
// wire within 300 ms; after reconnection the first frame is a stop, and motion needs a release and a new
// command. What the robot itself does without its cable is looked at in the world: an Eddie stands by its
// WATCH, a Kobuki drives on.
//
// Five pulls and five silences in all, which tell how long they took and, on a machine that has much else to
// do, are let off with a second;
// BANDWAGON_PULLS=300 makes it 300 of each with each base, and 300 ms.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>

#include <bandwagon_msgs/msg/base_state.hpp>
#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <gtest/gtest.h>
#include <std_srvs/srv/trigger.hpp>

#include "runtime/ros/service_call.hpp"
#include "runtime/ros/typed_topic.hpp"
#include "runtime/serial/emulator_path.hpp"
#include "tests/folder.hpp"
#include "tests/interop/cable/commands_on_wire.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using Clock = std::chrono::steady_clock;
using bandwagon_msgs::msg::BaseState;
using bandwagon_msgs::msg::GroundTruth;
using geometry_msgs::msg::Twist;
using std_srvs::srv::Trigger;
namespace base = bandwagon_msgs::msg::BaseState_Constants;
using std::chrono::milliseconds;

double ms_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double, std::milli>(to - from).count();
}

struct Figures {
  std::vector<double> ms;
  void print(const char* what) {
    std::ranges::sort(ms);
    std::printf("  %-48s median %6.1f ms, most %6.1f ms, %zu times\n", what, ms[ms.size() / 2], ms.back(),
                ms.size());
  }
};

struct Model {
  const char* name;
  int pulls;  ///< where nobody asks for more
  bool stands_by_itself;
};

class BehindACable : public testing::TestWithParam<Model> {
 protected:
  static std::string graph(const std::string& name) {
    return std::string(BANDWAGON_SOURCE_DIR) + "/tests/interop/cable/" + name + ".yaml";
  }
  static std::string robot() {
    return "robot=" + std::string(BANDWAGON_SOURCE_DIR) + "/config/robots/" + GetParam().name + ".yaml";
  }
  static int times() {
    const char* asked = std::getenv("BANDWAGON_PULLS");
    return asked == nullptr ? GetParam().pulls : std::atoi(asked);
  }
  static double limit_ms() { return std::getenv("BANDWAGON_PULLS") == nullptr ? 1000.0 : 300.0; }
  static dds::ParticipantOptions local() {
    return {.network = dds::Network::from_environment(dds::Transport::localhost)};
  }
  static int domain() { return local().network.domain_id; }

  BehindACable() {
    if (std::string(GetParam().name) == "eddie") wire_ = std::make_unique<EddieWire>();
  }

  /// As a planner does, at 20 Hz: to be called often.
  void drive() {
    if (Clock::now() < commanded_ + milliseconds(50)) return;
    Twist twist;
    twist.linear().x(0.3);
    commands_.publish(twist);
    commanded_ = Clock::now();
  }
  void look() {
    for (const WireCommand& command : wire_->read(cable_.take_sent())) {
      if (command.plugging != plugging_) first_ = command;
      plugging_ = command.plugging;
      sent_.push_back(command);
    }
    if (const auto truth = truths_.take_newest()) speed_ = truth->twist().linear().x();
    if (auto state = states_.take_newest()) {
      state_ = *state;
      heard_ = Clock::now();
    }
  }
  template <class Condition>
  bool until(Condition seen, bool drives) {
    return poll_until(Clock::now() + std::chrono::seconds(30), std::chrono::microseconds(500), [&] {
      if (drives) drive();
      look();
      return seen();
    });
  }
  bool wait(double ms, bool drives) {
    const auto end = Clock::now() + std::chrono::microseconds(static_cast<std::int64_t>(1e3 * ms));
    return until([&] { return Clock::now() >= end; }, drives);
  }
  /// At its full speed, which is what is on the wire for a tenth of a second.
  bool is_driving() {
    if (!until([&] { return state_.state() == base::DRIVING && !sent_.empty() && sent_.back().speed > 0; },
               true))
      return false;
    for (int fastest = 0; fastest < sent_.back().speed;) {
      fastest = sent_.back().speed;
      wait(150, true);
    }
    return true;
  }
  /// What interrupted a drive takes a release, which is refused until the cable is in again.
  bool is_released() {
    if (state_.is_latched()) call_service<Trigger>(participant_, "/release_stop", {}, milliseconds(500));
    return state_.state() <= base::WAITING;
  }
  void TearDown() override {
    for (Process* process : {&host_, &world_}) {
      process->signal(SIGINT);
      EXPECT_TRUE(process->wait(milliseconds(20'000))) << process->err();
    }
  }

  Folder folder_;
  Process world_{{BANDWAGON_PROGRAM, "run", graph("world"), "--set", robot(), "--stay"}};
  CableBetween cable_{emulator_path("base", domain()), folder_ / "cable"};
  Process host_{{BANDWAGON_PROGRAM, "run", graph("host"), "--stay", "--set", robot(), "--set",
                 "robot.base.port=" + (folder_ / "cable").string()}};
  dds::Participant participant_{local()};
  TopicWriter<Twist> commands_{participant_, "/cmd_vel", Qos::command()};
  TopicReader<BaseState> states_{participant_, "/base_state", Qos::standard(100)};
  TopicReader<GroundTruth> truths_{participant_, "/sim/ground_truth", Qos::standard(100)};
  std::unique_ptr<WireReader> wire_ = std::make_unique<KobukiWire>();
  std::mt19937 random_{7};
  Clock::time_point commanded_, heard_;
  std::vector<WireCommand> sent_;
  std::uint64_t plugging_ = 0;
  WireCommand first_;  ///< since the cable was put in
  BaseState state_;
  double speed_ = 0.0;  ///< of the robot on its floor [m/s]
};

// WATCH: motors off when nothing was heard for a second. The emulator's wheels then run down with a time
// constant of 0.1 s: from 0.3 to 0.01 m/s in 0.1 ln 30 = 0.34 s. What it heard last is at most a request's
// period old, 25 ms, when the cable goes.
TEST_P(BehindACable, PulledAndPutBack) {
  constexpr double kWatch = 1000.0, kRunsDown = 340.0, kLastByte = 25.0, kAmple = 1500.0;
  Figures declared, stands, back;
  std::uniform_real_distribution<double> moment(0.0, 300.0);
  for (int i = 0; i < times(); ++i) {
    ASSERT_TRUE(is_driving()) << i << ": " << state_.reason() << host_.err();
    ASSERT_TRUE(wait(moment(random_), true));
    const auto pulled = cable_.pull();
    ASSERT_TRUE(until([&] { return state_.state() == base::LINK; }, true)) << "pull " << i;
    declared.ms.push_back(ms_between(pulled, heard_));
    EXPECT_LE(declared.ms.back(), limit_ms()) << "pull " << i;
    EXPECT_NE(state_.device(), "") << "it names the cable";
    if (GetParam().stands_by_itself) {
      ASSERT_TRUE(until([&] { return std::abs(speed_) < 0.01; }, false)) << "pull " << i << ": it drives on";
      stands.ms.push_back(ms_between(pulled, Clock::now()));
      EXPECT_GE(stands.ms.back(), kWatch - kLastByte) << "pull " << i << ": not by WATCH";
      EXPECT_LE(stands.ms.back(), kWatch + kRunsDown + limit_ms()) << "pull " << i;
    } else if (i == 0) {
      ASSERT_TRUE(wait(kAmple, false));
      EXPECT_GT(speed_, 0.25) << "who drives on is not to be relied on, and is told so on the robots' page";
    }

    cable_.put_back();
    const auto put_back = Clock::now();
    sent_.clear();
    ASSERT_TRUE(until([&] { return plugging_ == cable_.pluggings(); }, false)) << "pull " << i;
    EXPECT_EQ(first_.speed, 0) << "pull " << i << ": the first frame is a stop";
    ASSERT_TRUE(until([&] { return is_released(); }, false)) << state_.reason();
    back.ms.push_back(ms_between(put_back, heard_));
    ASSERT_TRUE(wait(200.0, false));
    EXPECT_TRUE(std::ranges::all_of(sent_, [](const WireCommand& c) { return c.speed == 0; }))
        << "pull " << i << ": motion without a new command";
  }
  ASSERT_TRUE(is_driving()) << "a new command moves it";
  std::printf("%s, cable pulled:\n", GetParam().name);
  declared.print("until base_state says LINK");
  if (GetParam().stands_by_itself) stands.print("until it stands by itself");
  back.print("from putting back until it is released");
}

TEST_P(BehindACable, ASilentPlannerIsAStopOnTheWire) {
  Figures slower, stopped;
  std::uniform_real_distribution<double> moment(0.0, 50.0);
  for (int i = 0; i < times(); ++i) {
    ASSERT_TRUE(is_driving()) << i << ": " << state_.reason() << host_.err();
    ASSERT_TRUE(wait(moment(random_), true));
    const int full = sent_.back().speed;
    const auto silent = commanded_;
    sent_.clear();
    ASSERT_TRUE(until([&] { return !sent_.empty() && sent_.back().speed == 0; }, false)) << "silence " << i;
    const auto less = std::ranges::find_if(sent_, [&](const WireCommand& c) { return c.speed < full; });
    slower.ms.push_back(ms_between(silent, less->time));
    stopped.ms.push_back(ms_between(silent, sent_.back().time));
    EXPECT_LE(slower.ms.back(), limit_ms()) << "silence " << i;
  }
  std::printf("%s, planner silent:\n", GetParam().name);
  slower.print("until a slower command is on the wire");
  stopped.print("until it is a stop, after the ramp");
}

INSTANTIATE_TEST_SUITE_P(Bases, BehindACable,
                         testing::Values(Model{"kobuki", 3, false}, Model{"eddie", 2, true}),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace bw::test
