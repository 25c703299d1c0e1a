// The driver on a cable whose other end is a board that answers from a list.
#include "components/robot_base/eddie/eddie.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/components/robot_base/eddie_robot.hpp"
#include "tests/components/robot_base/scripted_link.hpp"

namespace bw::eddie {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

EddieOptions options_with_rangers() {
  EddieOptions options;
  options.sonar_pins = {0, 1};
  options.sonar_frames = {"sonar_left", "sonar_right"};
  options.infrared_channels = {1, 2};
  options.infrared_frames = {"infrared_left", "infrared_right"};
  return options;
}

class Bench {
 public:
  explicit Bench(const EddieOptions& options = options_with_rangers(), const Robot& robot = eddie_robot())
      : eddie(options, robot, std::make_unique<ScriptedLink>(wire)) {}

  /// 10 ms. A request is answered before the next look, unless the board is silent.
  Readings step(const WheelSpeeds& wheels = {}) {
    now = now + Duration::milliseconds(10);
    Readings readings = eddie.poll(now);
    took = eddie.command(now, wheels);
    for (const EncoderCounts& one : readings.counts) counts.push_back(one);
    for (const RangeReading& one : readings.ranges) ranges.push_back(one);
    if (readings.battery) battery = readings.battery;
    for (const Bytes& bytes : std::exchange(wire.from_host, {})) {
      const std::string line(bytes.begin(), bytes.end());
      sent.push_back(line);
      if (!is_silent) wire.put(answer(line));
    }
    return readings;
  }
  Readings steps(int count, const WheelSpeeds& wheels = {}) {
    Readings readings;
    for (int i = 0; i < count; ++i) readings = step(wheels);
    return readings;
  }
  /// Until the start is over: 80 ms, and nine requests of 10 ms.
  void start() {
    steps(20);
    ASSERT_TRUE(took);
    sent.clear();
  }
  std::string answer(const std::string& line) {
    if (line == "VERB 1\r") tells_reasons = true;
    if (line == "VERB\r") return tells_reasons ? "ERROR - Too few parameters\r" : "ERROR\r";
    const std::string word = line.substr(0, line.find_first_of(" \r"));
    const auto found = answers.find(word);
    return found == answers.end() ? "ERROR - Invalid command\r" : found->second;
  }

  std::map<std::string, std::string> answers = {{"STOP", "\r"},
                                                {"VERB", "\r"},
                                                {"VER", "0014\r"},
                                                {"HWVER", "0003\r"},
                                                {"WATCH", "\r"},
                                                {"ACC", "\r"},
                                                {"SPNG", "\r"},
                                                {"GOSPD", "\r"},
                                                {"DIST", "00000000 00000000\r"},
                                                {"ADC", "333 1D5 000 000 000 000 000 BF6\r"},
                                                {"PING", "3E8 000\r"}};
  ScriptedLink::Wire wire;
  Eddie eddie;
  Time now = Time::seconds(50.0);
  bool took = false, is_silent = false;
  bool tells_reasons = false;  ///< by VERB 1, until the board loses its power
  std::vector<std::string> sent;
  std::vector<EncoderCounts> counts;
  std::vector<RangeReading> ranges;
  std::optional<BatteryReading> battery;
};

TEST(Eddie, NothingMovesAtConnect) {
  Bench bench;
  bench.steps(17, {0.3, 0.3});
  // 3 m/s^2 / 3.3249 mm = 902 = 386; pins 0 and 1 are mask 3.
  EXPECT_THAT(bench.sent, ElementsAre("STOP 0\r", "STOP 0\r", "VERB\r", "VERB 1\r", "VERB\r", "VER\r",
                                      "HWVER\r", "WATCH 1\r", "ACC 386\r", "SPNG 3\r"));
  // 0.3 / 0.0033249 = 90.2 = 5A.
  const Readings readings = bench.steps(2, {0.3, 0.3});
  EXPECT_TRUE(readings.link.is_open);
  EXPECT_THAT(bench.sent, Contains("GOSPD 5A 5A\r"));
  EXPECT_EQ(bench.eddie.counters().at("firmware version"), 0x14U);
}

TEST(Eddie, TheFirstFrameAfterEachOpeningIsAStop) {
  Bench bench;
  bench.start();
  for (int i = 0; i < 3; ++i) {
    bench.steps(10, {0.3, 0.3});
    bench.wire.pull();
    EXPECT_FALSE(bench.step({0.3, 0.3}).link.is_open);
    EXPECT_FALSE(bench.took);
    bench.wire.plug_in();
    bench.sent.clear();
    bench.steps(8, {0.3, 0.3});
    EXPECT_THAT(bench.sent, ElementsAre("STOP 0\r"));
    bench.steps(15, {0.3, 0.3});
    EXPECT_TRUE(bench.took);
  }
}

TEST(Eddie, OneRequestAtATime) {
  Bench bench;
  bench.is_silent = true;
  std::vector<double> times;
  for (int i = 0; i < 300; ++i) {
    bench.step({0.3, 0.3});
    for (std::size_t k = 0; k < std::exchange(bench.sent, {}).size(); ++k)
      times.push_back(bench.now.to_seconds());
  }
  ASSERT_GT(times.size(), 10U);
  for (std::size_t i = 1; i < times.size(); ++i) EXPECT_GE(times[i] - times[i - 1], 0.08 - 1e-9);
}

// 10 s of looks each 10 ms, a command that changes all the time, and one that does not. A request waits for others by a look or two: GOSPD is
// due each 40 ms and comes within 60, DIST is due each 25 and comes within 40.
TEST(Eddie, AsksEachThingAtItsRate) {
  for (const bool changes : {true, false}) {
    Bench bench;
    bench.start();
    for (int i = 0; i < 1000; ++i) bench.step({changes && i % 2 == 0 ? 0.3 : 0.2, 0.1});
    std::map<std::string, int> asked;
    for (const std::string& line : bench.sent) ++asked[line.substr(0, 4)];
    EXPECT_GE(asked["GOSP"], changes ? 166 : 83);
    EXPECT_LE(asked["GOSP"], changes ? 250 : 101);
    EXPECT_GE(asked["DIST"], 250);
    EXPECT_LE(asked["DIST"], 400);
    EXPECT_NEAR(asked["ADC\r"], 50, 5);
    EXPECT_NEAR(asked["PING"], 50, 5);
  }
}

// At most what one look costs, while no reply is due.
TEST(Eddie, AStopDoesNotWaitForItsTurn) {
  Bench bench;
  bench.start();
  bench.steps(20, {0.3, 0.3});
  bench.sent.clear();
  bench.steps(1);
  EXPECT_THAT(bench.sent, ElementsAre("GOSPD 0 0\r"));
}

TEST(Eddie, HalfSecondsHalveTheNumbersAndWheelsHaveTheirOwnSize) {
  EddieOptions options;
  options.positions_per = PositionsPer::half_second;
  Robot robot = eddie_robot();
  robot.wheel_radius_ratio = 0.5;  // 0.1016 m and 0.0508 m
  Bench bench(options, robot);
  bench.start();
  bench.steps(10, {0.3, -0.3});
  // 0.3 m/s / (2 pi 0.1016 m / 144) / 2 = 33.84 = 22; -67.67 = -68 = FFBC.
  EXPECT_THAT(bench.sent, Contains("GOSPD 22 FFBC\r"));
}

TEST(Eddie, CountsAreOfTheMiddleOfTheirRequest) {
  Bench bench;
  bench.start();
  bench.answers["DIST"] = "0000000A FFFFFFF6\r";
  bench.counts.clear();
  bench.steps(10);
  ASSERT_FALSE(bench.counts.empty());
  EXPECT_EQ(bench.counts.back().left, 10);
  EXPECT_EQ(bench.counts.back().right, -10);
  const auto of_the_second = bench.counts.back().time.nanoseconds % 10'000'000;
  EXPECT_EQ(of_the_second, 5'000'000);  // asked at one look, there at the next
}

TEST(Eddie, RangesAndVoltage) {
  Bench bench;
  bench.start();
  bench.ranges.clear();
  bench.steps(50);
  const auto range = [&](std::size_t ranger) {
    double last = -1.0;
    for (const RangeReading& one : bench.ranges)
      if (one.ranger == ranger) last = one.range;
    return last;
  };
  EXPECT_NEAR(range(0), 1.000, 1e-9);                            // 3E8 = 1000 mm
  EXPECT_EQ(range(1), std::numeric_limits<double>::infinity());  // no echo
  // 333 = 819 of 4095 is 1 V: 0.60495 m. 1D5 = 469 is 0.5726 V: 0.60495 * 0.5726^-1.1904 = 1.1747 m.
  EXPECT_NEAR(range(2), 0.60495, 1e-9);
  EXPECT_NEAR(range(3), 1.1747, 1e-3);
  // BF6 = 3062; 3062 / 819 * 3.21 = 12.001 V.
  ASSERT_TRUE(bench.battery);
  EXPECT_NEAR(bench.battery->voltage, 12.001, 1e-3);
  const std::vector<Ranger> rangers = bench.eddie.rangers();
  ASSERT_EQ(rangers.size(), 4U);
  EXPECT_EQ(rangers[1].frame, "sonar_right");
  EXPECT_TRUE(rangers[2].is_infrared);
}

// A look each 10 ms; the newest answer may be 60 ms old when the board falls silent, 200 ms is the limit.
TEST(Eddie, ABoardThatStopsAnsweringIsToldWithin300Ms) {
  Bench bench;
  bench.start();
  bench.steps(20, {0.3, 0.3});
  bench.is_silent = true;
  int steps = 0;
  while (bench.step({0.3, 0.3}).link.is_open && steps < 100) ++steps;
  EXPECT_LE(steps, 22);
  EXPECT_GE(steps, 10);
  // Half a second, and it begins anew: the board may have restarted.
  bench.steps(60, {0.3, 0.3});
  bench.is_silent = false;
  bench.sent.clear();
  bench.steps(40, {0.3, 0.3});
  EXPECT_EQ(bench.sent.front(), "STOP 0\r");
  EXPECT_THAT(bench.sent, Contains("WATCH 1\r"));
  EXPECT_TRUE(bench.took);
}

TEST(Eddie, AFirmwareWithoutWatchIsAWarning) {
  Bench bench;
  bench.answers["WATCH"] = "ERROR - Invalid command\r";
  const Readings readings = bench.steps(20);
  EXPECT_TRUE(bench.took);
  EXPECT_THAT(readings.warning, HasSubstr("no WATCH"));
  EXPECT_EQ(readings.fault, "");
}

TEST(Eddie, ASettingThatIsRefusedIsToldWithItsReason) {
  Bench bench;
  bench.answers["ACC"] = "ERROR - Invalid parameter\r";
  EXPECT_THAT(bench.steps(20).warning, HasSubstr("refuses ACC 386 (Invalid parameter)"));
}

TEST(Eddie, ACommandThatIsRefusedAgainAndAgainIsAFault) {
  Bench bench;
  bench.start();
  bench.answers["GOSPD"] = "ERROR - Overflow\r";
  const Readings readings = bench.steps(30, {0.3, 0.3});
  EXPECT_THAT(readings.fault, HasSubstr("refuses GOSPD 5A 5A: Overflow"));
}

TEST(Eddie, OneErrorIsNone) {
  Bench bench;
  bench.start();
  bench.answers["GOSPD"] = "ERROR - Bad checksum\r";
  bench.steps(5, {0.3, 0.3});
  bench.answers["GOSPD"] = "\r";
  EXPECT_EQ(bench.steps(30, {0.3, 0.3}).fault, "");
}

TEST(Eddie, TextThatNobodyAskedForCostsAPause) {
  Bench bench;
  bench.start();
  bench.wire.put("Parallax Eddie 1.4\r");
  bench.wire.put("half a li");
  const Readings readings = bench.steps(60, {0.3, 0.3});
  EXPECT_TRUE(readings.link.is_open);
  EXPECT_TRUE(bench.took);
  EXPECT_GE(bench.eddie.counters().at("malformed replies") + bench.eddie.counters().at("unexpected lines"),
            1U);
}

TEST(Eddie, CountsThatJumpAreToldForASecond) {
  Bench bench;
  bench.answers["DIST"] = "00002710 00002710\r";
  bench.start();
  bench.steps(10);
  bench.answers["DIST"] = "00000000 00000000\r";
  const Readings readings = bench.steps(10);
  EXPECT_THAT(readings.fault, HasSubstr("DIST jumped by 10000"));
  EXPECT_EQ(bench.eddie.counters().at("encoder jumps"), 1U);
  EXPECT_EQ(bench.steps(120).fault, "");
}

// 0x10 is not far from 0, and a second is long: by the counts alone it could have driven there.
TEST(Eddie, ABoardThatRestartedInSilenceIsToldByTheVerbosityItForgot) {
  Bench bench;
  bench.answers["DIST"] = "00000010 00000010\r";
  bench.start();
  bench.steps(10);
  const EncoderCounts before = bench.counts.back();
  bench.is_silent = true;
  bench.steps(100);
  bench.is_silent = false;
  bench.tells_reasons = false;
  bench.answers["DIST"] = "00000000 00000000\r";
  std::string fault;
  for (int i = 0; i < 60; ++i)
    if (const Readings readings = bench.step(); readings.link.is_open && fault.empty())
      fault = readings.fault;
  EXPECT_THAT(fault, HasSubstr("the board restarted while it was not heard"));
  EXPECT_GT(bench.counts.back().time, before.time);
  EXPECT_EQ(bench.counts.back().left, before.left) << "no motion of it";
  bench.answers["DIST"] = "00000001 00000002\r";
  const Readings readings = bench.steps(120);
  EXPECT_EQ(bench.counts.back().left, before.left + 1);
  EXPECT_EQ(bench.counts.back().right, before.right + 2);
  EXPECT_EQ(readings.fault, "");
  EXPECT_EQ(bench.eddie.counters().at("restarts"), 1U);
}

TEST(Eddie, ABoardThatWasOnlySilentTellsWhatItTurnedMeanwhile) {
  Bench bench;
  bench.start();
  bench.steps(10);
  bench.is_silent = true;
  bench.steps(100);
  bench.is_silent = false;
  bench.answers["DIST"] = "00000010 00000010\r";
  bench.steps(60);
  EXPECT_EQ(bench.counts.back().left, 16);
  EXPECT_EQ(bench.eddie.counters().at("restarts"), 0U);
}

// 90 positions a second are told; 180 are done.
TEST(Eddie, ABoardOfTheOtherUnitIsAFault) {
  Bench bench;
  bench.start();
  std::string fault;
  for (int i = 0; i < 100 && fault.empty(); ++i) {
    const int count = static_cast<int>(1.8 * i);
    const std::string text = command("X", {count});
    const std::string digits = text.substr(2, text.size() - 3);
    const std::string padded = std::string(8 - digits.size(), '0') + digits;
    bench.answers["DIST"] = padded + " " + padded + "\r";
    fault = bench.step({0.3, 0.3}).fault;
  }
  EXPECT_THAT(fault, HasSubstr("robot.base.positions_per"));
}

TEST(Eddie, AKobukiIsToldInWords) {
  Bench bench;
  bench.is_silent = true;
  std::string fault;
  for (int i = 0; i < 200; ++i) {
    if (i % 2 == 0) bench.wire.put(Bytes{0xAA, 0x55, 0x04, 0x77, 0x02, 0x00, 0x00, 0x71});
    fault = bench.step({0.3, 0.3}).fault;
    for (const std::string& line : bench.sent) ASSERT_EQ(line, "STOP 0\r");
  }
  EXPECT_THAT(fault, HasSubstr("as a Kobuki does"));
}

TEST(Eddie, ADeviceThatIsNoEddieIsGivenUp) {
  Bench bench;
  bench.is_silent = true;
  for (int i = 0; i < 450 && bench.wire.state.is_open; ++i) {
    bench.wire.put(Bytes{0xF8, 0x00, 0x80});
    bench.step();
  }
  EXPECT_THAT(bench.wire.closed_because, HasSubstr("another speed of the line"));
  EXPECT_THAT(bench.wire.closed_because, StartsWith("no answer of an Eddie to STOP and VER, but bytes"));
}

TEST(Eddie, ASilentCableIsToldInWords) {
  Bench bench;
  bench.is_silent = true;
  EXPECT_THAT(bench.steps(150).link.fault, HasSubstr("switched on"));
}

TEST(Eddie, StopWritesAtOnceEvenWhenAReplyIsDue) {
  Bench bench;
  bench.start();
  bench.is_silent = true;
  bench.steps(3, {0.3, 0.3});
  bench.eddie.stop(bench.now);
  EXPECT_EQ(bench.wire.from_host.back(), bytes_of("STOP 0\r"));
  bench.wire.pull();
  bench.eddie.stop(bench.now);
}

TEST(Eddie, OptionsThatContradictEachOtherAreRefused) {
  EddieOptions options = options_with_rangers();
  EXPECT_FALSE(options.violated_rule());
  options.sonar_pins = {1, 0};
  EXPECT_THAT(options.violated_rule().value(), HasSubstr("ascend"));
  options.sonar_pins = {0};
  EXPECT_THAT(options.violated_rule().value(), HasSubstr("as many"));
  options = options_with_rangers();
  options.infrared_channels = {1, 8};
  EXPECT_THAT(options.violated_rule().value(), HasSubstr("8 is the supply"));
}

}  // namespace
}  // namespace bw::eddie
