// The emulated device alone, against the protocol's bytes.
#include "components/emulators/rplidar/rplidar_device.hpp"

#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace bw::emulators {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Bench {
  explicit Bench(const RplidarDeviceOptions& options = {}) : device(options, 1) {}
  Bytes ask(const Bytes& request) {
    device.receive(now, request);
    return run(0.005);
  }
  Bytes run(double seconds) {
    Bytes all;
    for (int i = 0; i < static_cast<int>(seconds / 0.005 + 0.5); ++i) {
      now = now + Duration::milliseconds(5);
      const auto sent = device.step(now, {-3.14159265, 2 * 3.14159265 / 720, ranges});
      all.insert(all.end(), sent.begin(), sent.end());
    }
    return all;
  }

  std::vector<float> ranges = std::vector<float>(720, 2.0F);
  Time now = Time::seconds(100.0);
  RplidarDevice device;
};

TEST(RplidarDevice, AnswersInfoHealthAndSampleTimes) {
  Bench bench({.health = 1, .health_code = 0x8002});
  const Bytes info = bench.ask({0xA5, 0x50});
  ASSERT_EQ(info.size(), 27U);
  EXPECT_EQ(Bytes(info.begin(), info.begin() + 11),
            (Bytes{0xA5, 0x5A, 0x14, 0x00, 0x00, 0x00, 0x04, 0x18, 0x1D, 0x01, 0x07}));
  EXPECT_EQ(bench.ask({0xA5, 0x52}), (Bytes{0xA5, 0x5A, 0x03, 0x00, 0x00, 0x00, 0x06, 0x01, 0x02, 0x80}));
  EXPECT_EQ(bench.ask({0xA5, 0x59}),
            (Bytes{0xA5, 0x5A, 0x04, 0x00, 0x00, 0x00, 0x15, 0xF4, 0x01, 0xF4, 0x01}));
}

// 2 m all round: 8000 = 1F40h in each node, whose size is 5; one in 285 or 286 starts a revolution.
TEST(RplidarDevice, MeasuresOnceItTurnsSteadily) {
  Bench bench;
  EXPECT_EQ(bench.ask({0xA5, 0x20}), (Bytes{0xA5, 0x5A, 0x05, 0x00, 0x00, 0x40, 0x81}));
  const Bytes early = bench.run(0.4);
  EXPECT_TRUE(early.empty()) << "spins up for 0.6 s, steady within 5 % of 7 Hz: 0.57 s";
  const Bytes stream = bench.run(2.0);
  ASSERT_EQ(stream.size() % 5, 0U);
  int starts = 0;
  for (std::size_t i = 0; i < stream.size(); i += 5) {
    EXPECT_NE(stream[i] & 1, stream[i] >> 1 & 1);
    EXPECT_EQ(stream[i + 1] & 1, 1);
    EXPECT_EQ(stream[i + 3], 0x40);
    EXPECT_EQ(stream[i + 4], 0x1F);
    starts += stream[i] & 1;
  }
  EXPECT_NEAR(static_cast<double>(stream.size()) / 5, 2000.0 * (2.4 - 0.57), 20.0);
  EXPECT_NEAR(starts, 7.0 * (2.4 - 0.57), 1.0);
  bench.ask({0xA5, 0x25});
  EXPECT_TRUE(bench.run(0.1).empty()) << "stopped";
}

TEST(RplidarDevice, WhatIsOutOfReachIsZero) {
  Bench bench({.spin_up = 0.0});
  bench.ranges.assign(720, std::numeric_limits<float>::infinity());
  bench.ask({0xA5, 0x20});
  const Bytes stream = bench.run(0.5);
  ASSERT_GE(stream.size(), 500U);
  for (std::size_t i = 0; i + 5 <= stream.size(); i += 5) {
    EXPECT_EQ(stream[i] >> 2, 0) << "quality";
    EXPECT_EQ(stream[i + 3] + stream[i + 4], 0);
  }
}

// An A2's motor stands until it is told; a wrong checksum tells nothing. Then it answers nothing for the half
// second of a reset.
TEST(RplidarDevice, ObeysTheMotorAndTheReset) {
  Bench bench({.model = 0x28});
  bench.ask({0xA5, 0xF0, 0x02, 0x58, 0x02, 0x0E});
  bench.run(1.0);
  EXPECT_EQ(bench.device.refused_requests(), 1U);
  EXPECT_EQ(bench.device.revolution_rate(), 0.0);
  bench.ask({0xA5, 0xF0, 0x02, 0x58, 0x02, 0x0D});
  bench.run(1.0);
  EXPECT_NEAR(bench.device.revolution_rate(), 7.0, 1e-6);
  bench.ask({0xA5, 0x40});
  EXPECT_TRUE(bench.ask({0xA5, 0x50}).empty());
  EXPECT_FALSE(bench.run(0.6).empty()) << "greets";
  EXPECT_EQ(bench.ask({0xA5, 0x50}).size(), 27U);
}

TEST(RplidarDevice, ABrokenOneDoesNotScan) {
  Bench bench({.health = 2});
  EXPECT_TRUE(bench.ask({0xA5, 0x20}).empty());
  EXPECT_FALSE(bench.device.is_scanning());
  EXPECT_EQ(bench.ask({0xA5, 0x21}).size(), 7U) << "forced";
}

}  // namespace
}  // namespace bw::emulators
