// Start, requests, counts and rangers of a board that does what it should.
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/components/robot_base/eddie/eddie_bench.hpp"

namespace bw::eddie {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

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

// 10 s of looks each 10 ms, a command that changes all the time, and one that does not. A request waits for
// others by a look or two: GOSPD is due each 40 ms and comes within 60, DIST is due each 25 and comes within
// 40.
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
