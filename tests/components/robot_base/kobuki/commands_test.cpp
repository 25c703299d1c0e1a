// Commands against the vectors of the protocol's notes and against what the firmware makes of them.
#include "components/robot_base/kobuki/commands.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace bw::kobuki {
namespace {

constexpr double kSeparation = 0.230;

Bytes control(double v, double w) {
  return base_control(speed_and_radius(to_wheel_speeds({v, w}, kSeparation), kSeparation));
}

TEST(KobukiCommands, BaseControlHasItsSpecialCases) {
  // 1000 * 0.2 = 200 = 00C8, radius 0; checksum 06 ^ 01 ^ 04 ^ C8 = CB.
  EXPECT_EQ(control(0.2, 0.0), (Bytes{0xAA, 0x55, 0x06, 0x01, 0x04, 0xC8, 0x00, 0x00, 0x00, 0xCB}));
  // In place: 1000 * 0.230 / 2 = 115 = 0073, radius 1.
  EXPECT_EQ(control(0.0, 1.0), (Bytes{0xAA, 0x55, 0x06, 0x01, 0x04, 0x73, 0x00, 0x01, 0x00, 0x71}));
  EXPECT_EQ(control(0.0, -1.0), (Bytes{0xAA, 0x55, 0x06, 0x01, 0x04, 0x8D, 0xFF, 0x01, 0x00, 0x70}));
  // r = 400 = 0190; (400 + 115) * 0.5 = 257.5, cut to 257 = 0101.
  EXPECT_EQ(control(0.2, 0.5), (Bytes{0xAA, 0x55, 0x06, 0x01, 0x04, 0x01, 0x01, 0x90, 0x01, 0x92}));
  // r = -400 = FE70; (-400 - 115) * -0.5 = 257.5.
  EXPECT_EQ(control(0.2, -0.5), (Bytes{0xAA, 0x55, 0x06, 0x01, 0x04, 0x01, 0x01, 0x70, 0xFE, 0x8D}));
  EXPECT_EQ(base_control({}), (Bytes{0xAA, 0x55, 0x06, 0x01, 0x04, 0x00, 0x00, 0x00, 0x00, 0x03}));
}

TEST(KobukiCommands, RequestsAndGains) {
  EXPECT_EQ(request_versions(), (Bytes{0xAA, 0x55, 0x04, 0x09, 0x02, 0x0B, 0x00, 0x04}));
  // 0E 01 00, length 3: 03 ^ 0E ^ 01 = 0C.
  EXPECT_EQ(request_gains(), (Bytes{0xAA, 0x55, 0x03, 0x0E, 0x01, 0x00, 0x0C}));
  // 100 * 1000 = 100000 = 000186A0, 0.1 * 1000 = 100 = 64, 2 * 1000 = 2000 = 07D0;
  // 0F ^ 0D ^ 0D ^ 01 = 0E, ^ A0 ^ 86 ^ 01 = 29, ^ 64 = 4D, ^ D0 ^ 07 = 9A.
  EXPECT_EQ(set_user_gains({}), (Bytes{0xAA, 0x55, 0x0F, 0x0D, 0x0D, 0x01, 0xA0, 0x86, 0x01, 0x00, 0x64, 0x00,
                                       0x00, 0x00, 0xD0, 0x07, 0x00, 0x00, 0x9A}));
}

TEST(KobukiCommands, NumbersThatDoNotFitAreLimitedAndNonsenseStops) {
  EXPECT_EQ(speed_and_radius({50.0, 50.0}, kSeparation), (SpeedAndRadius{32767, 0}));
  EXPECT_EQ(speed_and_radius({-50.0, -50.0}, kSeparation), (SpeedAndRadius{-32768, 0}));
  // w = 0.001, r = 1000 * 0.5 / 0.001 = 500000.
  EXPECT_EQ(speed_and_radius(to_wheel_speeds({0.5, 0.001}, kSeparation), kSeparation),
            (SpeedAndRadius{500, 32767}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(speed_and_radius({nan, 0.1}, kSeparation), SpeedAndRadius{});
  EXPECT_EQ(speed_and_radius({0.1, std::numeric_limits<double>::infinity()}, kSeparation), SpeedAndRadius{});
}

/// Wheels as the firmware rotates them for (speed, radius): the outer one at `speed`.
WheelSpeeds firmware(const SpeedAndRadius& motion) {
  const double s = motion.speed / 1000.0, r = motion.radius / 1000.0, half = kSeparation / 2.0;
  if (motion.radius == 0) return {s, s};
  if (motion.radius == 1) return {-s, s};
  const double outer = r > 0.0 ? r + half : r - half;
  const double w = s / outer;
  return to_wheel_speeds({w * r, w}, kSeparation);
}

// The outer wheel's speed is cut to 1 mm/s. The radius is cut to 1 mm, which moves the inner wheel by w * 2h
// / (|r| + h) for each mm, h = b / 2: at most 4.2 * 0.230 / 0.117 = 8.3 mm/s from 2 mm on. Below, 1 would
// mean in place.
TEST(KobukiCommands, TheFirmwareTurnsTheWheelsAsTold) {
  std::mt19937 random(16);
  std::uniform_real_distribution<double> v(-0.7, 0.7), w(-4.2, 4.2);
  int compared = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Twist2 twist{v(random), w(random)};
    const double radius = std::abs(1000.0 * twist.v / twist.omega);
    if (radius > 32'767.0 || (radius > 1.0 && radius < 2.0)) continue;
    ++compared;
    const WheelSpeeds told = to_wheel_speeds(twist, kSeparation);
    const WheelSpeeds made = firmware(speed_and_radius(told, kSeparation));
    ASSERT_NEAR(made.left, told.left, 0.010) << twist.v << " " << twist.omega;
    ASSERT_NEAR(made.right, told.right, 0.010) << twist.v << " " << twist.omega;
  }
  EXPECT_GT(compared, 19'000);
}

}  // namespace
}  // namespace bw::kobuki
