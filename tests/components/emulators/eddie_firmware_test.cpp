// The emulated Eddie against its command set: lines written out by hand, and numbers that follow from them.
#include "components/emulators/eddie/eddie_firmware.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "components/emulators/eddie/eddie_sensors.hpp"

namespace bw::emulators {
namespace {

/// Rotated wheels: 144 ticks a revolution, as the blue board counts.
const Robot kRobot{.wheel_radius = 0.0762, .wheel_separation = 0.39, .ticks_per_revolution = 144};
const double kMetresPerPosition = 2.0 * std::numbers::pi * 0.0762 / 144.0;

/// A board on a floor where wheels rotate as its motors say, in steps of 10 ms.
class Bench {
 public:
  explicit Bench(const EddieOptions& options = {}) : firmware_(options, kRobot) { step(); }

  /// After a step, so that counts are of now.
  std::string ask(const std::string& line) {
    const std::string bytes = line + "\r";
    step();
    const auto answer =
        firmware_.receive(now_, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    return {answer.begin(), answer.end()};
  }
  void step() {
    now_ = now_ + Duration::milliseconds(10);
    left_ += firmware_.motors().left * 0.01 / kMetresPerPosition;
    right_ += firmware_.motors().right * 0.01 / kMetresPerPosition;
    body.left_ticks = static_cast<std::int32_t>(std::floor(left_));
    body.right_ticks = static_cast<std::int32_t>(std::floor(right_));
    EXPECT_TRUE(firmware_.step(now_, body).empty());  // it never speaks unasked
  }
  void run(double seconds) {
    for (int i = 0; i < std::lround(seconds / 0.01); ++i) step();
  }
  /// As `run`, asking every half second, as a host does that keeps it awake.
  void run_awake(double seconds) {
    for (int i = 0; i < std::lround(seconds / 0.01); ++i)
      i % 50 == 0 ? static_cast<void>(ask("SPD")) : step();
  }
  double left() const { return left_; }
  double right() const { return right_; }
  void set_wheels(double left, double right) { left_ = left, right_ = right; }
  WheelSpeeds motors() const { return firmware_.motors(); }

  Body body;

 private:
  EddieFirmware firmware_;
  Time now_ = Time::seconds(100.0);
  double left_ = 0.0, right_ = 0.0;
};

TEST(EddieFirmware, AnswersAsItsDocumentSays) {
  Bench bench;
  EXPECT_EQ(bench.ask("VER"), "0103\r");
  EXPECT_EQ(bench.ask("HWVER"), "0001\r");
  EXPECT_EQ(bench.ask("VERB 1"), "\r");
  EXPECT_EQ(bench.ask("WATCH 1"), "\r");
  EXPECT_EQ(bench.ask("ACC 7FF"), "\r");
  EXPECT_EQ(bench.ask("SPD"), "0000 0000\r");
  EXPECT_EQ(bench.ask("DIST"), "00000000 00000000\r");
  EXPECT_EQ(bench.ask("HEAD"), "000\r");
  EXPECT_EQ(bench.ask("SPNG 1"), "\r");
  EXPECT_EQ(bench.ask("PING"), "000\r");
  EXPECT_EQ(bench.ask("OUT 10000"), "\r");
  EXPECT_EQ(bench.ask("HIGH 10003"), "\r");
  EXPECT_EQ(bench.ask("OUTS"), "00010000\r");
  EXPECT_EQ(bench.ask("HIGHS"), "00010003\r");
  EXPECT_EQ(bench.ask("LOWS"), "0006FFFC\r");
  EXPECT_EQ(bench.ask("INS"), "0006FFFF\r");
  EXPECT_EQ(bench.ask("READ"), "00010000\r");
  EXPECT_EQ(bench.ask("BLINK 3 A"), "\r");
  EXPECT_EQ(bench.ask("\t GOSPD \t 0  0 "), "\r");
  EXPECT_EQ(bench.ask(""), "");
  EXPECT_EQ(bench.motors(), WheelSpeeds{});
}

TEST(EddieFirmware, RefusesInItsOwnWords) {
  Bench bench;
  EXPECT_EQ(bench.ask("GOSPD 1"), "ERROR\r");
  bench.ask("VERB 1");
  EXPECT_EQ(bench.ask("GOSPD 1"), "ERROR - Too few parameters\r");
  EXPECT_EQ(bench.ask("GOSPD 1 1 1"), "ERROR - Too many parameters\r");
  EXPECT_EQ(bench.ask("GOSPD 1 G"), "ERROR - Invalid parameter\r");
  EXPECT_EQ(bench.ask("GOSPD 1 10000"), "ERROR - Invalid parameter\r");
  EXPECT_EQ(bench.ask("TRVL 10 100"), "ERROR - Invalid parameter\r");
  EXPECT_EQ(bench.ask("VERB 2"), "ERROR - Invalid parameter\r");
  EXPECT_EQ(bench.ask("FLY"), "ERROR - Invalid command\r");
  EXPECT_EQ(bench.ask("VER" + std::string(252, ' ')), "ERROR - Overflow\r");
  EXPECT_EQ(bench.ask("VER" + std::string(251, ' ')), "0103\r");
  EXPECT_EQ(bench.ask("V\x01\xFF\nER"), "0103\r");  // what is not printable is ignored
  EXPECT_EQ(bench.motors(), WheelSpeeds{});
}

TEST(EddieFirmware, TheOlderBoardKnowsLess) {
  Bench bench({.board = EddieBoard::position_controller, .has_watch = false});
  bench.ask("VERB 1");
  EXPECT_EQ(bench.ask("VER"), "0101\r");
  EXPECT_EQ(bench.ask("WATCH 1"), "ERROR - Invalid command\r");
  EXPECT_EQ(bench.ask("ACC 100"), "ERROR - Invalid parameter\r");
  EXPECT_EQ(bench.ask("TRVL 10 80"), "ERROR - Invalid parameter\r");
  bench.set_wheels(144.0, -8.0);  // 144 ticks a revolution: one is 36 of its positions, -8 are -2
  bench.step();
  EXPECT_EQ(bench.ask("DIST"), "00000024 FFFFFFFE\r");
}

TEST(EddieFirmware, CountsInTwosComplementSinceReset) {
  Bench bench;
  bench.set_wheels(-113.0, 4096.0);
  EXPECT_EQ(bench.ask("DIST"), "FFFFFF8F 00001000\r");
  bench.ask("RST");
  EXPECT_EQ(bench.ask("DIST"), "00000000 00000000\r");
  EXPECT_EQ(bench.ask("HEAD"), "000\r");
}

TEST(EddieFirmware, HeadingCountsClockwise) {
  // Left 30, right -30 positions: 60 * 3.3249 mm / 0.39 m = 0.5115 rad = 29.3 deg clockwise, 0x1D; the other
  // direction 360 - 29.3 = 0x14B.
  Bench bench;
  bench.set_wheels(30.0, -30.0);
  EXPECT_EQ(bench.ask("HEAD"), "01D\r");
  bench.set_wheels(-30.0, 30.0);
  EXPECT_EQ(bench.ask("HEAD"), "14B\r");
}

TEST(EddieFirmware, SpeedIsRampedWithAcc) {
  Bench bench;
  bench.ask("ACC 50");         // 80 positions/s^2
  bench.ask("GOSPD 5A FFA6");  // 90 and -90 positions/s
  bench.run(0.5);
  EXPECT_NEAR(bench.motors().left, 40.0 * kMetresPerPosition,
              0.81 * kMetresPerPosition);  // a step or two of 0.8
  bench.run_awake(2.0);
  EXPECT_NEAR(bench.motors().left, 90.0 * kMetresPerPosition, 1e-9);
  EXPECT_NEAR(bench.motors().right, -90.0 * kMetresPerPosition, 1e-9);
  EXPECT_EQ(bench.ask("SPD"), "005A FFA6\r");
}

TEST(EddieFirmware, UnitOfSpeedCanBeTheHalfSecond) {
  Bench bench({.speed_unit = SpeedUnit::per_half_second});
  bench.ask("ACC 7FF");
  bench.ask("GOSPD 2D 2D");  // 45 in half a second
  bench.run_awake(1.5);
  EXPECT_NEAR(bench.motors().left, 90.0 * kMetresPerPosition, 1e-9);
  EXPECT_EQ(bench.ask("SPD"), "002D 002D\r");
}

TEST(EddieFirmware, WatchSwitchesOffAfterASecondOfSilence) {
  for (const bool has_watch : {true, false}) {
    Bench bench({.has_watch = has_watch});
    bench.ask("ACC 7FF");
    bench.ask("GOSPD 50 50");
    bench.run(0.9);
    EXPECT_NEAR(bench.motors().left, 80.0 * kMetresPerPosition, 1e-9);
    bench.run(1.1);
    EXPECT_NEAR(bench.motors().left, has_watch ? 0.0 : 80.0 * kMetresPerPosition, 1e-3);
    bench.ask("DIST");  // being heard again is no command
    bench.run(0.3);
    EXPECT_NEAR(bench.motors().left, has_watch ? 0.0 : 80.0 * kMetresPerPosition, 1e-3);
  }
}

TEST(EddieFirmware, WatchCanBeSwitchedOffOrCountSeconds) {
  Bench off;
  off.ask("WATCH 0");
  Bench seconds({.watch_in_seconds = true});
  seconds.ask("WATCH 3");
  for (Bench* bench : {&off, &seconds}) {
    bench->ask("GOSPD 20 20");
    bench->run(2.9);
    EXPECT_NEAR(bench->motors().left, 32.0 * kMetresPerPosition, 1e-9);
    bench->run(1.0);
  }
  EXPECT_NEAR(off.motors().left, 32.0 * kMetresPerPosition, 1e-9);
  EXPECT_NEAR(seconds.motors().left, 0.0, 1e-3);
}

TEST(EddieFirmware, StopsAtOnceOrOverADistance) {
  Bench bench;
  bench.ask("ACC 7FF");
  bench.ask("GOSPD 64 64");
  bench.run_awake(1.0);
  const double before = bench.left();
  bench.ask("STOP 32");  // 50 positions from 100 positions/s: 100 positions/s^2, 1 s
  bench.run(0.5);
  EXPECT_NEAR(bench.motors().left, 50.0 * kMetresPerPosition, 2.0 * kMetresPerPosition);
  bench.run_awake(0.6);
  EXPECT_EQ(bench.motors().left, 0.0);
  EXPECT_NEAR(bench.left() - before, 50.0, 4.0);  // and the latency's 10 ms of 100 positions/s
  bench.ask("GOSPD 64 64");
  bench.run(0.5);
  bench.ask("STOP 0");
  bench.run(0.02);
  EXPECT_EQ(bench.motors().left, 0.0);
}

TEST(EddieFirmware, TravelsAndTurnsByWayAndAngle) {
  Bench bench;
  bench.ask("ACC 40");
  bench.ask("TRVL 12C 64");  // 300 positions at 100/s
  bench.run_awake(6.0);
  EXPECT_NEAR(bench.left(), 300.0, 2.0);
  EXPECT_NEAR(bench.right(), 300.0, 2.0);
  const double left = bench.left(), right = bench.right();
  bench.ask(
      "TURN FFA6 40");  // -90: counter-clockwise, the left wheel goes back; 0.39 m * pi / 4 = 92.1 positions
  bench.run_awake(5.0);
  EXPECT_NEAR(bench.left() - left, -92.1, 2.0);
  EXPECT_NEAR(bench.right() - right, 92.1, 2.0);
}

TEST(EddieFirmware, PowerDrivesWithoutALoop) {
  Bench bench;
  bench.ask("GO 80 7F");  // 80 counts as 81
  bench.run_awake(2.0);
  EXPECT_NEAR(bench.motors().left, -1.2, 1e-3);
  EXPECT_NEAR(bench.motors().right, 1.2, 1e-3);
}

TEST(EddieFirmware, TellsRangesAndSupply) {
  Bench bench;
  bench.body.ranges = {0.5, 3.5, 1.0, std::numeric_limits<double>::infinity()};
  bench.body.battery_voltage = 12.0;
  EXPECT_EQ(bench.ask("PING"), "1F4 000\r");  // 500 mm; beyond 0xB54
  const std::string converter = bench.ask("ADC");
  ASSERT_EQ(converter.size(), 8U * 4U);
  // 12 V / 3.21 * 819 = 3061.7; ten bits are real: 0xBF4. Infrared at 1 m: (60.495 / 100)^(1 / 1.1904) =
  // 0.6556 V, 537 of 4095: 0x218.
  EXPECT_EQ(converter.substr(28, 3), "BF4");
  EXPECT_EQ(converter.substr(0, 3), "218");
  Bench scaled({.ping_units_per_mm = 0.5});
  scaled.body.ranges = {0.5, 0.5, 1.0, 1.0};
  EXPECT_EQ(scaled.ask("PING"), "0FA 0FA\r");
}

}  // namespace
}  // namespace bw::emulators
