// Drivers and emulated firmware, which share no code, on one cable: what is commanded is what rotates and
// what is told.
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/emulators/eddie/eddie_firmware.hpp"
#include "components/emulators/kobuki/kobuki_firmware.hpp"
#include "components/robot_base/eddie/eddie.hpp"
#include "components/robot_base/kobuki/kobuki.hpp"
#include "tests/components/robot_base/eddie_robot.hpp"
#include "tests/components/robot_base/scripted_link.hpp"

namespace bw {
namespace {

using emulators::EddieFirmware;
using emulators::EmulatedBase;
using emulators::KobukiFirmware;
using testing::HasSubstr;

Robot kobuki_robot() {
  Robot robot;
  robot.wheel_radius = 0.035;
  robot.wheel_separation = 0.235;
  robot.ticks_per_revolution = 2578;
  robot.wheel_speed_max = 0.7;
  return robot;
}

/// Wheels that rotate as the firmware makes them, without slip.
class Bench {
 public:
  Bench(const Robot& robot, ScriptedLink::Wire& wire, Driver& driver, EmulatedBase& firmware)
      : metres_per_tick_(2.0 * std::numbers::pi * robot.wheel_radius /
                         static_cast<double>(robot.ticks_per_revolution)),
        separation_(robot.wheel_separation),
        wire_(wire),
        driver_(driver),
        firmware_(firmware) {}

  void run(double seconds, const std::function<WheelSpeeds(double)>& wheels) {
    for (double t = 0.0; t < seconds - 1e-9; t += 0.01) {
      now = now + Duration::milliseconds(10);
      const Readings readings = driver_.poll(now);
      driver_.command(now, wheels(t));
      if (!readings.fault.empty() && fault.empty()) fault = readings.fault, fault_at = t;
      for (const EncoderCounts& one : readings.counts) counts.push_back(one);
      for (const GyroReading& one : readings.gyro) heading = one.angle;
      if (readings.battery) battery = readings.battery;
      for (const Bytes& bytes : std::exchange(wire_.from_host, {})) wire_.put(firmware_.receive(now, bytes));
      body.left_ticks = static_cast<std::int32_t>(std::lround(travel.left / metres_per_tick_));
      body.right_ticks = static_cast<std::int32_t>(std::lround(travel.right / metres_per_tick_));
      const WheelSpeeds turning = firmware_.motors();
      body.twist = to_twist(turning, separation_);
      wire_.put(firmware_.step(now, body));
      travel.left += turning.left * 0.01;
      travel.right += turning.right * 0.01;
    }
    counters = driver_.counters();
  }
  WheelSpeeds counted() const {
    return {(counts.back().left - counts.front().left) * metres_per_tick_,
            (counts.back().right - counts.front().right) * metres_per_tick_};
  }

  Time now = Time::seconds(20.0);
  emulators::Body body;
  WheelSpeeds travel;
  std::vector<EncoderCounts> counts;
  std::map<std::string, std::uint64_t> counters;
  std::optional<BatteryReading> battery;
  std::string fault;
  double fault_at = -1.0, heading = 0.0;

 private:
  double metres_per_tick_, separation_;
  ScriptedLink::Wire& wire_;
  Driver& driver_;
  EmulatedBase& firmware_;
};

WheelSpeeds course(double t) {
  if (t < 1.0 || t >= 13.0) return {};
  if (t < 5.0) return {0.3, 0.3};
  if (t < 8.0) return {0.1, 0.25};
  if (t < 10.0) return {-0.15, 0.15};
  return {-0.2, -0.1};
}
// Left 4 * 0.3 + 3 * 0.1 - 2 * 0.15 - 3 * 0.2, right 4 * 0.3 + 3 * 0.25 + 2 * 0.15 - 3 * 0.1.
constexpr WheelSpeeds kTravel = {0.6, 1.95};

// A millimetre a second that base control cuts off makes 12 mm in 12 s, radius and ramps another 20.
TEST(DriverAndFirmware, KobukiGoesTheWayThatIsCommanded) {
  const Robot robot = kobuki_robot();
  ScriptedLink::Wire wire;
  kobuki::Kobuki driver({}, robot.wheel_radii(), std::make_unique<ScriptedLink>(wire));
  KobukiFirmware firmware({.first_stamp = 60'000, .first_ticks = 65'000}, robot, 1);
  Bench bench(robot, wire, driver, firmware);
  bench.run(15.0, course);
  EXPECT_EQ(bench.fault, "");
  EXPECT_NEAR(bench.travel.left, kTravel.left, 0.035);
  EXPECT_NEAR(bench.travel.right, kTravel.right, 0.035);
  EXPECT_NEAR(bench.counted().left, bench.travel.left, 1e-3);
  EXPECT_NEAR(bench.counted().right, bench.travel.right, 1e-3);
  // Its gyro's noise and drift are within 0.03 rad in 15 s.
  EXPECT_NEAR(bench.heading, (bench.travel.right - bench.travel.left) / robot.wheel_separation, 0.03);
  EXPECT_EQ(bench.counters.at("bad checksums") + bench.counters.at("bytes thrown away"), 0U);
  EXPECT_EQ(bench.counters.at("clock jumps") + bench.counters.at("encoder jumps"), 0U);
  EXPECT_GT(bench.counters.at("firmware version"), 0U);
  EXPECT_GE(bench.counts.size(), 745U);  // 50 a second
}

/// Driver and firmware of an Eddie after `seconds` of the course.
struct EddieRun {
  EddieRun(const eddie::EddieOptions& options, const emulators::EddieOptions& board, double seconds)
      : robot(robot_with(board)),
        driver(options, robot, std::make_unique<ScriptedLink>(wire)),
        firmware(board, robot) {
    bench.run(seconds, course);
  }
  static Robot robot_with(const emulators::EddieOptions& board) {
    Robot robot = eddie_robot();
    if (board.board == emulators::EddieBoard::position_controller) robot.ticks_per_revolution = 36;
    return robot;
  }

  Robot robot;
  ScriptedLink::Wire wire;
  eddie::Eddie driver;
  EddieFirmware firmware;
  Bench bench{robot, wire, driver, firmware};
};

// GOSPD is a whole number of positions: 3.3 mm/s, of which a half may be lost for 12 s; ramps lose both ways.
// With 36 to a revolution four times that.
TEST(DriverAndFirmware, EddieGoesTheWayThatIsCommanded) {
  using emulators::EddieBoard;
  using emulators::SpeedUnit;
  for (const EddieBoard board : {EddieBoard::quadrature, EddieBoard::position_controller}) {
    for (const SpeedUnit unit : {SpeedUnit::per_second, SpeedUnit::per_half_second}) {
      const bool is_half = unit == SpeedUnit::per_half_second;
      const eddie::EddieOptions options{.positions_per = is_half ? eddie::PositionsPer::half_second
                                                                 : eddie::PositionsPer::second};
      const EddieRun run(options, {.board = board, .speed_unit = unit}, 15.0);
      const Bench& bench = run.bench;
      const double count = board == EddieBoard::quadrature ? 0.0033 : 0.0133;
      EXPECT_EQ(bench.fault, "") << is_half << count;
      EXPECT_NEAR(bench.travel.left, kTravel.left, 0.03 + (is_half ? 12.0 : 6.0) * count) << is_half << count;
      EXPECT_NEAR(bench.travel.right, kTravel.right, 0.03 + (is_half ? 12.0 : 6.0) * count)
          << is_half << count;
      EXPECT_NEAR(bench.counted().left, bench.travel.left, 2.0 * count);
      EXPECT_NEAR(bench.counted().right, bench.travel.right, 2.0 * count);
      EXPECT_EQ(bench.counters.at("timeouts") + bench.counters.at("malformed replies"), 0U);
      EXPECT_EQ(bench.counters.at("errors") + bench.counters.at("unexpected lines"), 0U);
      ASSERT_TRUE(bench.battery);
      EXPECT_NEAR(bench.battery->voltage, 12.5, 0.4);
    }
  }
}

TEST(DriverAndFirmware, AnEddieOfTheOtherUnitIsToldWithinASecondOfDriving) {
  using emulators::SpeedUnit;
  const EddieRun fast({}, {.speed_unit = SpeedUnit::per_half_second}, 5.0);
  EXPECT_THAT(fast.bench.fault, HasSubstr("count positions per half second"));
  EXPECT_LT(fast.bench.fault_at, 1.6);
  const eddie::EddieOptions half{.positions_per = eddie::PositionsPer::half_second};
  const EddieRun slow(half, {}, 5.0);
  EXPECT_THAT(slow.bench.fault, HasSubstr("count positions per second"));
}

// Its power fails for a second after 0.09 m, 27 positions: it counts from zero again, which the wheels could
// have turned back to meanwhile.
TEST(DriverAndFirmware, AnEddieThatLostItsPowerInSilenceIsNoticed) {
  const Robot robot = eddie_robot();
  ScriptedLink::Wire wire;
  eddie::Eddie driver({}, robot, std::make_unique<ScriptedLink>(wire));
  EddieFirmware firmware({}, robot);
  Bench bench(robot, wire, driver, firmware);
  bench.run(3.0, [](double t) { return t < 1.0 || t > 1.5 ? WheelSpeeds{} : WheelSpeeds{0.2, 0.2}; });
  ASSERT_EQ(bench.fault, "");
  const EncoderCounts before = bench.counts.back();
  ASSERT_GT(before.left, 10);
  for (int i = 0; i < 100; ++i) {
    bench.now = bench.now + Duration::milliseconds(10);
    static_cast<void>(driver.poll(bench.now));
    driver.command(bench.now, {});
    wire.from_host.clear();
  }
  EddieFirmware again({}, robot);
  Bench after(robot, wire, driver, again);
  after.now = bench.now;
  after.run(1.0, [](double) { return WheelSpeeds{}; });
  EXPECT_THAT(after.fault, HasSubstr("the board restarted while it was not heard"));
  ASSERT_FALSE(after.counts.empty());
  EXPECT_EQ(after.counts.back().left, before.left);
  EXPECT_EQ(after.counters.at("restarts"), 1U);
}

TEST(DriverAndFirmware, AnEddieWithoutWatchDrivesAndSaysSo) {
  const EddieRun run({}, {.has_watch = false}, 15.0);
  const Bench& bench = run.bench;
  EXPECT_EQ(bench.fault, "");
  EXPECT_NEAR(bench.travel.right, kTravel.right, 0.05);
  EXPECT_EQ(bench.counters.at("errors"), 1U);
}

/// Whether the wheels stand after `spoiled` bytes of `command` and the guardian's stop.
bool stands_after(EmulatedBase& firmware, const Bytes& running, const Bytes& command, std::size_t spoiled,
                  const Bytes& stop) {
  Time now = Time::seconds(20.0);
  const auto live = [&](double seconds) {
    for (double t = 0.0; t < seconds; t += 0.01) firmware.step(now = now + Duration::milliseconds(10), {});
  };
  live(0.1);
  firmware.receive(now, running);
  live(1.0);
  if (firmware.motors().left < 0.1) return false;  // it never drove
  firmware.receive(now, std::span(command).first(spoiled));
  firmware.receive(now, stop);
  live(2.0);
  return std::abs(firmware.motors().left) < 1e-3 && std::abs(firmware.motors().right) < 1e-3;
}

// A process may be killed in the middle of a frame.
TEST(StopFrame, IsHeardByAKobukiAfterAnyPartOfAnyCommand) {
  const Bytes drive = kobuki::base_control({300, 0});
  for (const Bytes& command :
       {drive, kobuki::set_user_gains({}), kobuki::request_versions(), kobuki::request_gains()}) {
    for (std::size_t spoiled = 0; spoiled < command.size(); ++spoiled) {
      KobukiFirmware firmware({}, kobuki_robot(), 1);
      EXPECT_TRUE(stands_after(firmware, drive, command, spoiled, kobuki::Kobuki::stop_frame()))
          << spoiled << " of " << command.size() << " bytes";
    }
  }
}

TEST(StopFrame, IsHeardByAnEddieAfterAnyPartOfAnyCommand) {
  const Bytes drive = bytes_of("GOSPD 40 40\r");
  for (const char* text :
       {"GOSPD 60 60\r", "GO 7F 7F\r", "TRVL 7FFF 60\r", "DIST\r", "STOP 0\r", "ACC 40\r"}) {
    const Bytes command = bytes_of(text);
    for (std::size_t spoiled = 0; spoiled < command.size(); ++spoiled) {
      EddieFirmware firmware({}, eddie_robot());
      EXPECT_TRUE(stands_after(firmware, drive, command, spoiled, eddie::Eddie::stop_frame()))
          << text << spoiled;
    }
  }
}

}  // namespace
}  // namespace bw
