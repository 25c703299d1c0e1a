// robot_base on its topics, in lock-step, with a driver of the test behind the seam: what it tells, and how
// it is stopped and released from outside.
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/base_state.hpp>
#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <gtest/gtest.h>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/battery_state.hpp>
#include <sensor_msgs/msg/imu.hpp>
#include <sensor_msgs/msg/range.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_srvs/srv/trigger.hpp>

#include "components/messages/wheel_joints.hpp"
#include "components/robot_base/driver_registry.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {
namespace {

using bandwagon_msgs::msg::BaseState;
using std_srvs::srv::Trigger;
namespace state = bandwagon_msgs::msg::BaseState_Constants;

/// What the driver of the test tells at each poll, and what it was told.
struct Bench {
  Readings next;
  bool is_mute = false;
  std::vector<WheelSpeeds> told;
  double left = 0.0, right = 0.0;
  int stops = 0;
};
Bench* g_bench = nullptr;

struct BenchOptions {
  double speed_scale = 1.0;
  double velocity_window = 0.0;
  template <class Visitor>
  void fields(Visitor& v) {
    v("speed_scale", speed_scale, {.min = 0, .max = 2, .doc = "wheels turn this much of what they are told"});
    v("velocity_window", velocity_window, {.unit = "s", .min = 0, .max = 1, .doc = "that it asks for"});
  }
};

class BenchDriver final : public Driver {
 public:
  BenchDriver(const BenchOptions& options, const DriverContext& context)
      : scale_(options.speed_scale),
        velocity_window_(options.velocity_window),
        ticks_per_metre_(2578.0 / (2.0 * 3.14159265 * context.robot.wheel_radius)) {}
  Readings poll(Time now) override {
    Bench& bench = *g_bench;
    bench.left += wheels_.left * scale_ * 0.01;
    bench.right += wheels_.right * scale_ * 0.01;
    Readings readings = bench.next;
    readings.link.device = "/dev/bench";
    ++frames_;
    if (!bench.is_mute)
      readings.counts.push_back({now, static_cast<std::int32_t>(bench.left * ticks_per_metre_),
                                 static_cast<std::int32_t>(bench.right * ticks_per_metre_)});
    for (auto& gyro : readings.gyro) gyro.time = now;
    for (auto& range : readings.ranges) range.time = now;
    return readings;
  }
  std::map<std::string, std::uint64_t> counters() const override { return {{"frames", frames_}}; }
  bool command(Time, const WheelSpeeds& wheels) override {
    wheels_ = wheels;
    g_bench->told.push_back(wheels);
    return true;
  }
  void stop(Time) override { ++g_bench->stops; }
  std::vector<Ranger> rangers() const override {
    return {{.frame = "ping0", .field_of_view = 0.3, .min_range = 0.02, .max_range = 3.0},
            {.frame = "ir0", .is_infrared = true, .field_of_view = 0.05, .min_range = 0.1, .max_range = 0.8}};
  }
  BaseFacts facts() const override {
    return {.has_gyro = true,
            .has_battery = true,
            .velocity_window = velocity_window_,
            .battery_low = 14.0,
            .battery_empty = 13.2};
  }

 private:
  double scale_, velocity_window_, ticks_per_metre_;
  WheelSpeeds wheels_;
  std::uint64_t frames_ = 0;
};

BW_DRIVER(BenchDriver, BenchOptions, "bench")

class BaseTopics : public testing::Test {
 protected:
  void SetUp() override { g_bench = &bench_; }
  void TearDown() override { g_bench = nullptr; }

  /// Drives at 0.3 m/s all the time; `at(t)` every 10 ms.
  void run(double seconds, const std::function<void(bw::Setup&)>& more = {},
           const std::function<void(double t)>& at = {}, const std::string& base = "driver: bench") {
    run_with_script("robot: {base: {" + base + "}}\ncomponents: {robot_base: {}}", seconds,
                    [&](bw::Setup& setup) {
                      setup.input<BaseState>("base_state", Qos::standard(50),
                                             [&](const auto& m, const Tick&) { states_.push_back(m); });
                      stop_ = setup.output<std_msgs::msg::Bool>("emergency_stop");
                      release_ = setup.client<Trigger>("release_stop");
                      setup.every(Duration::milliseconds(10), "bench", [&, at](const Tick& tick) {
                        if (at) at(seconds_since_start(tick.now));
                      });
                      setup.every(Duration::milliseconds(20), "drive",
                                  [out = setup.command<sensor_msgs::msg::JointState>("wheel_commands")](
                                      const Tick& tick) mutable {
                                    out.publish(to_joint_state({0.3, 0.3}, Robot().wheel_radii(), tick.now));
                                  });
                      if (more) more(setup);
                    });
  }
  void press(bool is_pressed) {
    std_msgs::msg::Bool message;
    message.data(is_pressed);
    stop_.publish(message);
  }
  void release() {
    release_.call({}, Duration::milliseconds(500), [this](const Trigger::Response* response, const Tick&) {
      answers_.push_back(
          response == nullptr ? "none" : (response->success() ? "yes: " : "no: ") + response->message());
    });
  }
  bool is_at(double t, double when) const { return std::abs(t - when) < 1e-6; }

  Bench bench_;
  std::vector<BaseState> states_;
  std::vector<std::string> answers_;
  Output<std_msgs::msg::Bool> stop_;
  Client<Trigger> release_;
};

TEST_F(BaseTopics, TellsItsStateTenTimesASecondAndWhatItHas) {
  bench_.next.battery = BatteryReading{.voltage = 15.2, .charge = 0.8};
  bench_.next.gyro = {{.rate = 0.25}};
  bench_.next.ranges = {{.ranger = 1, .range = 0.4}};
  bench_.next.buttons = 5;
  bench_.next.currents = CurrentReading{.left = 0.5, .right = 0.6};
  std::vector<sensor_msgs::msg::BatteryState> batteries;
  sensor_msgs::msg::Imu imu;
  sensor_msgs::msg::Range range;
  int pings = 0;
  run(2.05, [&](bw::Setup& setup) {
    setup.input<sensor_msgs::msg::BatteryState>("battery_state", Qos::standard(),
                                                [&](const auto& m, const Tick&) { batteries.push_back(m); });
    setup.input<sensor_msgs::msg::Imu>("base/imu", Qos::standard(),
                                       [&](const auto& m, const Tick&) { imu = m; });
    setup.input<sensor_msgs::msg::Range>("range/ir0", Qos::standard(),
                                         [&](const auto& m, const Tick&) { range = m; });
    setup.input<sensor_msgs::msg::Range>("range/ping0", Qos::standard(),
                                         [&](const auto&, const Tick&) { ++pings; });
  });
  // 20 by the clock; cable and buttons, then driving are news of the first 20 ms.
  EXPECT_GE(states_.size(), 21U);
  EXPECT_LE(states_.size(), 23U);
  const BaseState& last = states_.back();
  EXPECT_EQ(last.state(), state::DRIVING);
  EXPECT_EQ(last.reason(), "");
  EXPECT_EQ(last.device(), "/dev/bench");
  EXPECT_EQ(last.buttons(), 5U);
  EXPECT_FLOAT_EQ(last.current_right(), 0.6F);
  EXPECT_NEAR(last.commanded_left(), 0.3, 1e-6);
  EXPECT_NEAR(last.measured_left(), 0.3, 0.01);
  ASSERT_EQ(batteries.size(), 3U);  // once a second
  EXPECT_FLOAT_EQ(batteries[0].voltage(), 15.2F);
  EXPECT_FLOAT_EQ(batteries[0].percentage(), 0.8F);
  EXPECT_EQ(batteries[0].power_supply_status(),
            sensor_msgs::msg::BatteryState_Constants::POWER_SUPPLY_STATUS_DISCHARGING);
  EXPECT_EQ(imu.angular_velocity().z(), 0.25);
  EXPECT_EQ(imu.orientation_covariance()[0], -1.0);
  EXPECT_EQ(imu.header().frame_id(), "base_link");
  EXPECT_EQ(range.header().frame_id(), "ir0");
  EXPECT_EQ(range.radiation_type(), sensor_msgs::msg::Range_Constants::INFRARED);
  EXPECT_FLOAT_EQ(range.range(), 0.4F);
  EXPECT_EQ(pings, 0);
  EXPECT_EQ(bench_.stops, 1);  // at its end
}

TEST_F(BaseTopics, AnEmergencyStopHoldsUntilItIsOverAndReleased) {
  std::size_t first_of_pause = 0;
  run(6.0, {}, [&](double t) {
    if (is_at(t, 1.0)) press(true);
    if (is_at(t, 1.5)) release();
    if (is_at(t, 2.0)) press(false);
    if (is_at(t, 2.5)) {
      EXPECT_EQ(bench_.told.back(), WheelSpeeds{});
    }
    if (is_at(t, 3.0)) release();
    if (is_at(t, 3.1)) first_of_pause = states_.size();
    if (is_at(t, 4.9)) {
      EXPECT_EQ(bench_.told.back(), WheelSpeeds{});
      EXPECT_EQ(states_[first_of_pause].reason(), "drives on in 2 s");
      EXPECT_EQ(states_.back().reason(), "drives on in 1 s");
      EXPECT_EQ(states_.back().state(), state::WAITING);
    }
  });
  EXPECT_EQ(answers_, (std::vector<std::string>{"no: the emergency stop is pressed by /script",
                                                "yes: released: drives on in 2 s"}));
  const auto stop =
      std::ranges::find(states_, state::EMERGENCY_STOP, [](const auto& s) { return s.state(); });
  ASSERT_NE(stop, states_.end());
  EXPECT_TRUE(stop->is_latched());
  EXPECT_NEAR(seconds_since_start(from_stamp(stop->header().stamp())), 1.0, 1e-9);
  EXPECT_EQ(states_.back().state(), state::DRIVING);
  EXPECT_EQ(bench_.told.back(), (WheelSpeeds{0.3, 0.3}));
}

TEST_F(BaseTopics, ABumperIsToldAtOnceAndBackedOff) {
  run(4.0, {}, [&](double t) {
    if (is_at(t, 1.01)) bench_.next.contacts = ContactReading{.bumper_right = true};
    if (is_at(t, 3.5)) release();
  });
  const auto touch = std::ranges::find_if(states_, [](const BaseState& s) { return s.bumper_right(); });
  ASSERT_NE(touch, states_.end());
  EXPECT_EQ(touch->state(), state::BACKING_OFF);
  EXPECT_EQ(touch->reason(), "bumper: right");
  EXPECT_NEAR(seconds_since_start(from_stamp(touch->header().stamp())), 1.01, 0.0101);
  EXPECT_EQ(states_.back().state(), state::BUMPER);
  EXPECT_EQ(answers_, std::vector<std::string>{"no: bumper: right"});
  // 1 s at 0.3 m/s, then back: -0.1 m/s until 0.1425 m.
  EXPECT_NEAR(bench_.left, 0.3 * 1.0 - 0.145, 0.01);
}

TEST_F(BaseTopics, SilenceNamesTheCableAndSaysWhatOdometryMissed) {
  std::vector<std::string> told;
  run(
      4.0,
      [&](bw::Setup& setup) {
        setup.input<diagnostic_msgs::msg::DiagnosticArray>(
            "/diagnostics", Qos::standard(),
            [&](const auto& m, const Tick&) {
              for (const auto& status : m.status()) {
                if (status.name().find("robot_base") == std::string::npos) continue;
                told.push_back(status.message());
                for (const auto& value : status.values()) told.push_back(value.key() + "=" + value.value());
              }
            },
            Need::optional);
      },
      [&](double t) {
        if (is_at(t, 1.0)) bench_.is_mute = true;
        if (is_at(t, 2.5)) bench_.is_mute = false;
      });
  const auto says = [&](const std::string& text) { return std::ranges::find(told, text) != told.end(); };
  EXPECT_TRUE(says("device=/dev/bench"));
  EXPECT_TRUE(says("/dev/bench is silent; until release_stop"));
  EXPECT_TRUE(std::ranges::any_of(told, [](const std::string& text) { return text.starts_with("frames="); }));
  // Silent from 1.00 to 2.50 s. It drives on at 0.3 m/s for `silence` of 0.2 s, and the ramp takes v^2 / 2 a
  // = 0.0225 m more.
  const auto missed = std::ranges::find_if(
      told, [](const auto& t) { return t.starts_with("odometry without counts=1 times, 1.5"); });
  ASSERT_NE(missed, told.end()) << testing::PrintToString(told);
  const double metres = std::stod(missed->substr(missed->find(" s, ") + 4));
  EXPECT_NEAR(metres, 0.2 * 0.3 + 0.0225, 0.01);
  EXPECT_EQ(states_.back().state(), state::LINK);  // it is heard again, and was interrupted
  EXPECT_TRUE(states_.back().is_latched());
}

TEST_F(BaseTopics, ADriverWithoutFieldsReadsNothingOfAnothersSection) {
  EXPECT_NO_THROW(run_with_script(
      "robot: {base: {driver: simulated, port: /dev/nothing}}\ncomponents: {robot_base: {}, world: {}}", 0.1,
      [](bw::Setup& setup) { setup.command<sensor_msgs::msg::JointState>("wheel_commands"); }));
}

TEST_F(BaseTopics, AnUnknownDriverIsRefusedWithTheNearestName) {
  try {
    run(0.1, {}, {}, "driver: bensh");
    FAIL() << "not refused";
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find("bench"), std::string::npos) << error.what();
  }
}

// Readings come every 10 ms. An emergency stop brakes from 0.3 m/s with 2 m/s^2, 0.15 s long: at its end the
// mean of the last 0.2 s, (0.05 * 0.3 + 0.0225) / 0.2 = 0.19 m/s, is 0.13 m/s more than that of the last 0.06
// s, which the parameter says.
TEST_F(BaseTopics, SpeedIsAveragedForAsLongAsTheDriverAsks) {
  for (const bool asks : {true, false}) {
    bench_ = {};
    std::vector<nav_msgs::msg::Odometry> told;
    run(
        1.5,
        [&](bw::Setup& setup) {
          setup.input<nav_msgs::msg::Odometry>("odom", Qos::sensor(),
                                               [&](const auto& m, const Tick&) { told.push_back(m); });
        },
        [&](double t) {
          if (is_at(t, 0.8)) press(true);
        },
        asks ? "driver: bench, velocity_window: 0.2" : "driver: bench");
    ASSERT_GT(told.size(), 100U);
    const auto mean = [&](std::size_t i, std::size_t readings) {
      const double distance =
          told[i].pose().pose().position().x() - told[i - readings].pose().pose().position().x();
      return distance / (0.01 * static_cast<double>(readings));
    };
    double most_beside = 0.0;
    for (std::size_t i = 20; i < told.size(); ++i) {
      ASSERT_NEAR(told[i].twist().twist().linear().x(), mean(i, asks ? 20 : 6), 1e-6) << i;
      most_beside = std::max(most_beside, std::abs(mean(i, 20) - mean(i, 6)));
    }
    EXPECT_NEAR(most_beside, 0.13, 0.02);
  }
}

TEST_F(BaseTopics, AWheelThatLagsIsAStallThatIsTold) {
  run(2.0, {}, {}, "driver: bench, speed_scale: 0.3");
  EXPECT_EQ(states_.back().state(), state::STALL);
  EXPECT_TRUE(states_.back().is_latched());
  EXPECT_EQ(bench_.told.back(), WheelSpeeds{});
}

}  // namespace
}  // namespace bw
