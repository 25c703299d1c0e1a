// The emulated base as a component, with the world behind it: what goes over its cable, and what the wheels
// do.
#include <cmath>
#include <numbers>
#include <optional>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <std_msgs/msg/u_int8_multi_array.hpp>

#include "runtime/parameters/config_error.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {
namespace {

using ::testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

const Bytes kKobukiForward = {0xAA, 0x55, 0x06, 0x01, 0x04,
                              0x2C, 0x01, 0x00, 0x00, 0x2E};  // 300 mm/s, straight on

struct Scene {
  std::string driver = "kobuki";
  std::string robot = "ticks_per_revolution: 2578, wheel_radius: 0.035, wheel_separation: 0.23, radius: 0.18";
  std::string world;
  std::string emulator;
  std::string fault;  ///< of the emulator's parameters, as the graph's `faults:` has it
};

std::string graph(const Scene& scene) {
  const std::string fault =
      scene.fault.empty() ? "" : "faults: {f: {kind: parameters, of: base_emulator, " + scene.fault + "}}\n";
  return fault + "robot: {" + scene.robot + ", base: {driver: " + scene.driver +
         ", port: emulator}}\n"
         "components:\n"
         "  world: {manager: none, parameters: {encoder_rate: 100, walls: [{x1: 3, y1: -5, x2: 3, y2: 5}]" +
         scene.world +
         "}}\n"
         "  base_emulator: {manager: none, parameters: {" +
         scene.emulator + "}}\n";
}

/// What a host at the other end sees, and what it says: `talk` is called every 20 ms with the time since the
/// start.
struct Host {
  std::function<Bytes(double)> talk = [](double) { return Bytes{}; };
  Bytes heard;
  double last_heard = 0.0;
  std::optional<bandwagon_msgs::msg::GroundTruth> truth;
};

void run(const Scene& scene, double seconds, Host& host) {
  run_with_script(graph(scene), seconds, [&host](Setup& setup) {
    const auto to_device =
        setup.output<std_msgs::msg::UInt8MultiArray>("sim/base/to_device", Qos::standard(1000));
    setup.input<std_msgs::msg::UInt8MultiArray>(
        "sim/base/from_device", Qos::standard(1000), [&host](const auto& message, const Tick& tick) {
          host.heard.insert(host.heard.end(), message.data().begin(), message.data().end());
          host.last_heard = seconds_since_start(tick.now);
        });
    setup.input<bandwagon_msgs::msg::GroundTruth>(
        "sim/ground_truth", Qos::standard(),
        [&host](const auto& message, const Tick&) { host.truth = message; });
    setup.every(Duration::milliseconds(20), "talk", [&host, to_device](const Tick& tick) {
      std_msgs::msg::UInt8MultiArray message;
      message.data() = host.talk(seconds_since_start(tick.now));
      if (!message.data().empty()) to_device.publish(message);
    });
  });
}

/// Data of sub-payload `id` in each packet with a good frame, oldest first.
std::vector<Bytes> parts(const Bytes& stream, std::uint8_t id) {
  std::vector<Bytes> found;
  for (std::size_t i = 0; i + 4 <= stream.size(); ++i) {
    if (stream[i] != 0xAA || stream[i + 1] != 0x55 || i + 4U + stream[i + 2] > stream.size()) continue;
    const std::size_t end = i + 3U + stream[i + 2];
    for (std::size_t at = i + 3; at + 2 <= end; at += 2U + stream[at + 1])
      if (stream[at] == id)
        found.emplace_back(stream.begin() + at + 2, stream.begin() + at + 2 + stream[at + 1]);
  }
  return found;
}

int u16(const Bytes& data, std::size_t at) { return data[at] | data[at + 1] << 8; }
std::int16_t difference(int now, int before) { return static_cast<std::int16_t>(now - before); }

Bytes text(const std::string& line) { return {line.begin(), line.end()}; }

TEST(BaseEmulator, AKobukiStandsAtTheStartAndTellsItEvery20Milliseconds) {
  Host host;
  run({}, 2.0, host);
  const std::vector<Bytes> cores = parts(host.heard, 0x01);
  EXPECT_NEAR(static_cast<double>(cores.size()), 100.0, 2.0);
  EXPECT_EQ(u16(cores.back(), 5), u16(cores.front(), 5));
  EXPECT_EQ(difference(u16(cores.back(), 0), u16(cores.front(), 0)), 20 * static_cast<int>(cores.size() - 1));
  EXPECT_EQ(host.truth->twist().linear().x(), 0.0);
}

TEST(BaseEmulator, AKobukiDrivesWhatItIsToldAndCountsItThroughTheWrap) {
  // 0.3 m/s for the last 4 of 5 s: 1.2 m and 11724.4 ticks/m (2578 a revolution: 11722.9), less what the
  // start takes; the counters begin 1000 below their wrap.
  Host host;
  host.talk = [](double time) { return time >= 1.0 ? kKobukiForward : Bytes{}; };
  run({.world = ", drive: {slip: 0.02, noise: 0.00003, first_tick: 64536}"}, 5.0, host);
  const std::vector<Bytes> cores = parts(host.heard, 0x01);
  const double ticks_per_metre = 2578.0 / (2.0 * std::numbers::pi * 0.035);
  for (const std::size_t wheel : {5U, 7U}) {
    EXPECT_EQ(u16(cores.front(), wheel), 64'536);
    double counted = 0.0;
    double fastest = 0.0;
    for (std::size_t i = 1; i < cores.size(); ++i) {
      const int step = difference(u16(cores[i], wheel), u16(cores[i - 1], wheel));
      fastest = std::max(fastest, std::abs(static_cast<double>(step)));
      counted += step;
    }
    EXPECT_LT(u16(cores.back(), wheel), 64'536);  // it has wrapped
    // Start: 20 ms on the way, 20 ms latency, 40 ms lag and 0.1 s of ramp cost at most 0.06 m. Noise: sd
    // sqrt(0.00003 * 1.2) = 6 mm.
    EXPECT_GT(counted / ticks_per_metre, 1.2 - 0.06 - 0.024);
    EXPECT_LT(counted / ticks_per_metre, 1.2 + 0.024);
    EXPECT_LT(fastest, 400.0);
  }
  // The floor sees 2 % less than the wheels.
  EXPECT_NEAR(host.truth->twist().linear().x(), 0.3 * 0.98, 1e-3);
}

TEST(BaseEmulator, AKobukiGoesOnWithoutCommandsAndItsBumperTellsTheWall) {
  // 0.3 m/s from 1 s on, last told at 1.1 s; the wall is 3 m - 0.18 m away, which takes 9.4 s.
  Host host;
  host.talk = [](double time) { return time >= 1.0 && time < 1.1 ? kKobukiForward : Bytes{}; };
  run({}, 12.0, host);
  EXPECT_NEAR(host.truth->pose().position().x(), 3.0 - 0.18, 0.004);
  const std::vector<Bytes> cores = parts(host.heard, 0x01);
  EXPECT_EQ(cores[cores.size() / 2][2], 0);
  EXPECT_EQ(cores.back()[2], 2);  // centre
  // Wheels that are held at 0.3 m/s less than told: 4.5 A * 0.3 / 0.7 = 1.93 A.
  EXPECT_NEAR(parts(host.heard, 0x06).back()[0], 193, 1);
}

TEST(BaseEmulator, AnEddieAnswersAndStopsWhenNothingIsHeard) {
  // ACC 400 and 60 positions/s of 3.3249 mm: 0.3192 m/s (0x60 = 96) from 0.5 s on; silence from 2 s on, stop
  // a second later.
  const Scene eddie{
      .driver = "eddie",
      .robot = "ticks_per_revolution: 144, wheel_radius: 0.0762, wheel_separation: 0.39, radius: 0.225"};
  Host host;
  host.talk = [](double time) {
    if (time < 0.5 || time >= 2.0) return Bytes{};
    return time < 0.51 ? text("ACC 400\rGOSPD 60 60\r") : text("DIST\r");
  };
  run(eddie, 2.9, host);
  EXPECT_NEAR(host.truth->twist().linear().x(), 0.3192, 1e-3);
  EXPECT_THAT(std::string(host.heard.begin(), host.heard.end()), HasSubstr("\r00000000 00000000\r"));
  EXPECT_LT(host.last_heard, 2.05);
  run(eddie, 3.5, host);
  EXPECT_NEAR(host.truth->twist().linear().x(), 0.0, 5e-3);
}

TEST(BaseEmulator, NoByteGetsThroughAPulledCable) {
  Host host;
  host.talk = [](double) { return kKobukiForward; };
  const Scene pulled{.fault = "for: 1s, parameters: {faults.cable_pulled: true}"};
  run(pulled, 0.98, host);
  EXPECT_TRUE(host.heard.empty());
  EXPECT_EQ(host.truth->twist().linear().x(), 0.0);
  run(pulled, 2.0, host);
  EXPECT_NEAR(static_cast<double>(parts(host.heard, 0x01).size()), 50.0, 2.0);
  EXPECT_NEAR(host.truth->twist().linear().x(), 0.3, 1e-3);
}

TEST(BaseEmulator, AHungFirmwareLeavesTheWheelsAsTheyAre) {
  Host host;
  host.talk = [](double time) {
    return time < 1.5 ? kKobukiForward : Bytes{0xAA, 0x55, 6, 1, 4, 0, 0, 0, 0, 3};
  };
  run({.fault = "from: 1s, parameters: {faults.hung: true}"}, 2.5, host);
  EXPECT_NEAR(host.truth->twist().linear().x(), 0.3, 1e-3);
  EXPECT_LT(host.last_heard, 1.05);
}

TEST(BaseEmulator, AnotherModelAnswersInItsOwnTongue) {
  Host host;
  host.talk = [](double) { return text("VER\r"); };
  run({.emulator = "faults: {other_model: true}"}, 1.0, host);
  EXPECT_THAT(std::string(host.heard.begin(), host.heard.end()), HasSubstr("0103\r"));
  EXPECT_TRUE(parts(host.heard, 0x01).empty());
}

TEST(BaseEmulator, WheelsRunAwayOnTheirOwn) {
  Host host;
  run({.fault = "from: 1s, parameters: {faults.runaway_left: 0.2, faults.runaway_right: 0.2}"}, 2.0, host);
  EXPECT_NEAR(host.truth->twist().linear().x(), 0.2, 1e-3);
}

TEST(BaseEmulator, ADriverWithoutAnEmulatorIsRefused) {
  Host host;
  try {
    run({.driver = "trolley"}, 0.1, host);
    FAIL() << "not refused";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("robot.base.driver = trolley: has no emulator"));
  }
}

}  // namespace
}  // namespace bw
