// What the driver tells of a board that goes wrong, or is none.
#include <cstdio>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/components/robot_base/eddie/eddie_bench.hpp"

namespace bw::eddie {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::StartsWith;

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
// One bit of one answer to DIST, each of them in turn, while the robot stands: what makes another count of it
// is told as a fault or is within what wheels can rotate, and odometry stays within that.
TEST(Eddie, AFlippedBitOfDistMovesNoStandingRobot) {
  const std::string sound = "00000000 00000000\r";
  const Robot robot = eddie_robot();
  int counted = 0, told = 0;
  for (std::size_t bit = 0; bit < 8 * sound.size(); ++bit) {
    Bench bench;
    bench.start();
    EncoderOdometry odometry(robot, {});
    double farthest = 0.0;
    bool is_fault = false, is_counted = false;
    bench.counts.clear();
    const auto look = [&](int steps) {
      for (int i = 0; i < steps; ++i) {
        const Readings readings = bench.step();
        is_fault |= !readings.fault.empty();
        for (const EncoderCounts& counts : readings.counts) {
          is_counted |= counts.left != 0 || counts.right != 0;
          odometry.add(counts.time, counts);
          const Pose2& pose = odometry.state().X_OB;
          farthest = std::max({farthest, std::abs(pose.x), std::abs(pose.y)});
        }
      }
    };
    look(30);
    bench.answers["DIST"] = sound;
    bench.answers["DIST"][bit / 8] =
        static_cast<char>(static_cast<unsigned char>(sound[bit / 8]) ^ 1U << bit % 8);
    const std::size_t before = bench.counts.size();
    for (int i = 0; i < 20 && bench.counts.size() == before; ++i) look(1);
    bench.answers["DIST"] = sound;
    look(60);
    // Between two answers are 25 ms to 100 ms; see encoder_odometry_test.cpp.
    const double reach =
        2.0 * (robot.limits.v_max + robot.limits.omega_max * robot.wheel_separation / 2.0) * 0.1;
    ASSERT_LE(farthest, reach) << "bit " << bit;
    ASSERT_NEAR(odometry.state().X_OB.x, 0.0, 1e-9) << "bit " << bit;
    counted += is_counted ? 1 : 0;
    told += is_fault ? 1 : 0;
  }
  std::printf("%d flips are another count, %d are told\n", counted, told);
  EXPECT_GT(counted, 16);
  EXPECT_GT(told, 0);
}

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

// Both wheels at 0.3 m/s all the time, 3.3 mm a count. Whenever the host does nothing for a quarter of a
// second, the counts that it takes are of the moments that they are stamped with, but for half an exchange of
// 10 ms (1.5 mm) and a count: 0.02 s of driving. Taken in the middle of a quarter of a second, an answer
// would be 0.12 s off.
TEST(Eddie, CountsThatLayWhileTheHostWasHeldUpAreNotTaken) {
  constexpr double kSpeed = 0.3, kCount = 0.0033;
  for (int before = 0; before < 12; ++before) {
    Bench bench;
    bench.start();
    const Time start = bench.now;
    const auto counts_at = [&](Time t) { return kSpeed * (t - start).to_seconds() / kCount; };
    const auto step = [&] {
      char text[20];
      const auto count = static_cast<unsigned>(counts_at(bench.now + Duration::milliseconds(10)));
      std::snprintf(text, sizeof text, "%08X %08X\r", count, count);
      bench.answers["DIST"] = text;
      bench.step({kSpeed, kSpeed});
    };
    for (int i = 0; i < 20 + before; ++i) step();
    bench.now = bench.now + Duration::milliseconds(250);
    bench.counts.clear();
    for (int i = 0; i < 20; ++i) step();
    ASSERT_GE(bench.counts.size(), 3U);
    for (const EncoderCounts& one : bench.counts)
      EXPECT_NEAR(one.left * kCount / kSpeed, counts_at(one.time) * kCount / kSpeed, 0.02) << before;
  }
}

}  // namespace
}  // namespace bw::eddie
