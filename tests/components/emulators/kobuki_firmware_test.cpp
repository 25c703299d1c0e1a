// The emulated Kobuki against its protocol: bytes written out by hand, and numbers that follow from them.
#include "components/emulators/kobuki/kobuki_firmware.hpp"

#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bw::emulators {
namespace {

using ::testing::ElementsAreArray;
using Bytes = std::vector<std::uint8_t>;

constexpr double kTolerance = 1e-3;  // [m/s]

Time at(double seconds) { return Time::seconds(100.0 + seconds); }

Bytes sent_at(KobukiFirmware& firmware, double seconds, const Body& body = {}) {
  const auto bytes = firmware.step(at(seconds), body);
  return {bytes.begin(), bytes.end()};
}

/// Steps of 10 ms from `from` up to `to`, with wheels that do what the motors say.
void run(KobukiFirmware& firmware, double from, double to) {
  const Robot robot{.wheel_separation = 0.230};
  Body body;
  for (int i = 0; from + 0.01 * i < to - 1e-9; ++i) {
    body.twist = to_twist(firmware.motors(), robot.wheel_separation);
    firmware.step(at(from + 0.01 * i), body);
  }
}

KobukiFirmware quiet_firmware(KobukiOptions options = {}) {
  options.gyro.first_angle = 10.0;
  return {options, Robot{.wheel_radius = 0.035, .wheel_separation = 0.230}, 1};
}

/// Data of the first sub-payload `id` of a packet; empty: it has none.
Bytes part(const Bytes& packet, std::uint8_t id) {
  for (std::size_t i = 3; i + 2 <= packet.size() - 1; i += 2U + packet[i + 1]) {
    if (packet[i] == id) return {packet.begin() + i + 2, packet.begin() + i + 2 + packet[i + 1]};
  }
  return {};
}

TEST(KobukiFirmware, SendsThePacketThatItsProtocolDescribes) {
  KobukiFirmware firmware = quiet_firmware();
  Body body{.left_ticks = 100, .right_ticks = 0x1234};
  body.contacts = {.bumper_left = true, .bumper_right = true, .cliff_centre = true, .drop_left = true};
  body.buttons = 2;
  body.charger = Charger::adapter;
  body.battery_voltage = 16.0;
  const Bytes expected = {
      0xAA, 0x55, 0x41,                                            // 65 bytes follow
      0x01, 0x0F, 0x00, 0x00, 0x05, 0x02, 0x02,                    // stamp 0; bumpers 1 + 4, drop 2, cliff 2
      0x64, 0x00, 0x34, 0x12, 0x00, 0x00, 0x02, 0x16, 0xA0, 0x00,  // ticks, pwm, button, charger 22, 16.0 V
      0x03, 0x03, 0x00, 0x00, 0x00,                                // no dock
      0x04, 0x07, 0xE8, 0x03, 0x01, 0x00, 0x00, 0x00, 0x00,        // 10.00 deg, 0.01 deg/s
      0x05, 0x06, 0xA4, 0x06, 0xFA, 0x00, 0xA4, 0x06,              // floor 1700, none 250
      0x06, 0x02, 0x00, 0x00,                                      // no current
      0x0D, 0x02, 0x00, 0x00,                                      // no gyro sample yet
      0x10, 0x10, 0,    0,    0,    0,    0,    0,    0,    0,    0, 0, 0, 0, 0, 0, 0, 0, 0xA7};
  EXPECT_THAT(sent_at(firmware, 0.0, body), ElementsAreArray(expected));
}

TEST(KobukiFirmware, SendsEvery20Milliseconds) {
  KobukiFirmware firmware = quiet_firmware();
  int packets = 0;
  for (int i = 0; i <= 100; ++i) packets += sent_at(firmware, 0.01 * i).empty() ? 0 : 1;
  EXPECT_EQ(packets, 51);  // at 0, 20, ... 1000 ms
}

TEST(KobukiFirmware, ClockAndTicksWrapAt16Bits) {
  KobukiFirmware firmware = quiet_firmware({.first_stamp = 65'530, .first_ticks = 65'535});
  sent_at(firmware, 0.0);
  const Bytes core = part(sent_at(firmware, 0.02, {.left_ticks = 3, .right_ticks = -2}), 0x01);
  EXPECT_EQ(core[0] | core[1] << 8, 14);      // 65530 + 20 - 65536
  EXPECT_EQ(core[5] | core[6] << 8, 2);       // 65535 + 3 - 65536
  EXPECT_EQ(core[7] | core[8] << 8, 65'533);  // 65535 - 2
}

/// Vectors of the protocol for (v, w); wheel speeds are v -+ 0.115 w.
struct CommandCase {
  Bytes bytes;
  double left, right;
};

class KobukiCommand : public ::testing::TestWithParam<CommandCase> {};

TEST_P(KobukiCommand, TurnsTheWheels) {
  KobukiFirmware firmware = quiet_firmware();
  run(firmware, 0.0, 0.02);
  firmware.receive(at(0.02), GetParam().bytes);
  run(firmware, 0.02, 1.5);
  EXPECT_NEAR(firmware.motors().left, GetParam().left, kTolerance);
  EXPECT_NEAR(firmware.motors().right, GetParam().right, kTolerance);
}

INSTANTIATE_TEST_SUITE_P(
    OfTheProtocol, KobukiCommand,
    ::testing::Values(
        CommandCase{{0xAA, 0x55, 0x06, 0x01, 0x04, 0xC8, 0x00, 0x00, 0x00, 0xCB}, 0.2, 0.2},
        CommandCase{{0xAA, 0x55, 0x06, 0x01, 0x04, 0x73, 0x00, 0x01, 0x00, 0x71}, -0.115, 0.115},
        CommandCase{{0xAA, 0x55, 0x06, 0x01, 0x04, 0x8D, 0xFF, 0x01, 0x00, 0x70}, 0.115, -0.115},
        CommandCase{{0xAA, 0x55, 0x06, 0x01, 0x04, 0x01, 0x01, 0x90, 0x01, 0x92}, 0.1425, 0.2575},
        CommandCase{{0xAA, 0x55, 0x06, 0x01, 0x04, 0x01, 0x01, 0x70, 0xFE, 0x8D}, 0.2575, 0.1425}));

TEST(KobukiFirmware, StandsUntilItIsTold) {
  KobukiFirmware firmware = quiet_firmware();
  run(firmware, 0.0, 2.0);
  EXPECT_EQ(firmware.motors(), WheelSpeeds{});
}

TEST(KobukiFirmware, ObeysLateAndNoFasterThanItsMotors) {
  // Latency 20 ms, then at most 3 m/s^2: 0.09 m/s after three steps, 0.2 m/s not before 67 ms of them.
  KobukiFirmware firmware = quiet_firmware({.wheels = {.latency = 0.02, .lag = 0.0, .acceleration = 3.0}});
  firmware.step(at(0.0), {});
  firmware.receive(at(0.0), Bytes{0xAA, 0x55, 0x06, 0x01, 0x04, 0xC8, 0x00, 0x00, 0x00, 0xCB});
  run(firmware, 0.01, 0.02);
  EXPECT_EQ(firmware.motors().left, 0.0);
  run(firmware, 0.02, 0.05);
  EXPECT_NEAR(firmware.motors().left, 0.09, 1e-9);
}

TEST(KobukiFirmware, DrivesOnWhenCommandsCeaseUnlessItIsAnotherOne) {
  const Bytes straight = {0xAA, 0x55, 0x06, 0x01, 0x04, 0xC8, 0x00, 0x00, 0x00, 0xCB};
  KobukiFirmware assumed = quiet_firmware();
  KobukiFirmware other = quiet_firmware({.stops_by_itself = 0.6});
  for (KobukiFirmware* firmware : {&assumed, &other}) {
    run(*firmware, 0.0, 0.1);
    firmware->receive(at(0.1), straight);
    run(*firmware, 0.1, 0.7);
    EXPECT_NEAR(firmware->motors().left, 0.2, kTolerance);
    run(*firmware, 0.7, 5.0);
  }
  EXPECT_NEAR(assumed.motors().left, 0.2, kTolerance);
  EXPECT_NEAR(other.motors().left, 0.0, kTolerance);
}

TEST(KobukiFirmware, AnswersRequestsOnceAndPassesOverWhatItDoesNotKnow) {
  KobukiFirmware firmware = quiet_firmware();
  sent_at(firmware, 0.0);
  // Garbage, a packet with a wrong checksum, one with an unknown sub-payload 7E before the request 0B.
  firmware.receive(at(0.01), Bytes{0x00, 0xAA, 0xAA, 0x55, 0x04, 0x09, 0x02, 0x0F, 0x00, 0x04});
  firmware.receive(at(0.01), Bytes{0xAA, 0x55, 0x07, 0x7E, 0x01, 0x33});
  firmware.receive(at(0.01), Bytes{0x09, 0x02, 0x0B, 0x00, 0x07 ^ 0x7E ^ 0x01 ^ 0x33 ^ 0x09 ^ 0x02 ^ 0x0B});
  const Bytes answer = sent_at(firmware, 0.02);
  EXPECT_THAT(part(answer, 0x0A), ElementsAreArray(Bytes{4, 0, 1, 0}));
  EXPECT_THAT(part(answer, 0x0B), ElementsAreArray(Bytes{0, 2, 1, 0}));
  EXPECT_EQ(part(answer, 0x13).size(), 12U);
  EXPECT_TRUE(part(answer, 0x15).empty());
  EXPECT_TRUE(part(sent_at(firmware, 0.04), 0x0B).empty());
}

TEST(KobukiFirmware, TellsItsGains) {
  KobukiFirmware firmware = quiet_firmware();
  const Bytes get_gains = {0xAA, 0x55, 0x03, 0x0E, 0x01, 0x00, 0x0C};
  firmware.receive(at(0.0), get_gains);
  // Factory: P 100, I 0.1, D 2, times 1000.
  EXPECT_THAT(part(sent_at(firmware, 0.0), 0x15),
              ElementsAreArray(Bytes{0, 0xA0, 0x86, 0x01, 0x00, 0x64, 0, 0, 0, 0xD0, 0x07, 0, 0}));
}

TEST(KobukiFirmware, GyroComesInFramesOfTwoOrThreeSamples) {
  KobukiOptions options;
  options.gyro = {.bias = 0.5, .noise = 0.1, .drift = 0.0, .first_angle = 0.0};
  KobukiFirmware firmware(options, Robot{.wheel_radius = 0.035, .wheel_separation = 0.230}, 3);
  Body body;
  body.twist.omega = 0.5;
  std::vector<double> rates;
  std::size_t three = 0, packets = 0;
  Bytes last;
  for (int i = 0; i <= 400; ++i) {
    const Bytes packet = sent_at(firmware, 0.01 * i, body);
    if (packet.empty() || i == 0) continue;
    last = packet;
    const Bytes gyro = part(packet, 0x0D);
    ASSERT_EQ(gyro.size(), 2U + 2U * gyro[1]);
    ASSERT_TRUE(gyro[1] == 6 || gyro[1] == 9) << int(gyro[1]);
    ++packets;
    three += gyro[1] == 9 ? 1U : 0U;
    for (std::size_t s = 0; s < gyro[1] / 3U; ++s)
      rates.push_back(0.00875 * static_cast<std::int16_t>(gyro[2 + 6 * s + 4] | gyro[2 + 6 * s + 5] << 8));
  }
  // 104 a second: 416 in 4 s, which is 2 a packet and 16 more.
  EXPECT_EQ(packets, 200U);
  EXPECT_NEAR(static_cast<double>(three), 16.0, 1.0);
  EXPECT_EQ(part(last, 0x0D)[0], static_cast<std::uint8_t>(rates.size()));
  // 0.5 rad/s = 28.648 deg/s and the bias; the mean of 416 samples of 0.1 deg/s errs by 0.005 (4 sigma:
  // 0.02).
  const double mean = std::accumulate(rates.begin(), rates.end(), 0.0) / static_cast<double>(rates.size());
  EXPECT_NEAR(mean, 28.648 + 0.5, 0.02);
  // After 4 s it has rotated by 114.59 deg, and tells it without the bias.
  const Bytes inertia = part(last, 0x04);
  EXPECT_NEAR(static_cast<std::int16_t>(inertia[0] | inertia[1] << 8), 11'459, 2);
  EXPECT_NEAR(static_cast<std::int16_t>(inertia[2] | inertia[3] << 8), 2'865, 1);
}

TEST(KobukiFirmware, HeldWheelsTakeCurrentUntilTheBoardSwitchesThemOff) {
  // 0.6 m/s told (0x0258) and none turned: 4.5 A * 0.6 / 0.7 = 3.9 A is above 3 A.
  KobukiFirmware firmware = quiet_firmware();
  const Bytes fast = {0xAA, 0x55, 0x06, 0x01, 0x04, 0x58, 0x02, 0x00, 0x00, 0x06 ^ 0x01 ^ 0x04 ^ 0x58 ^ 0x02};
  firmware.receive(at(0.0), fast);
  double most = 0.0;
  Bytes last;
  for (int i = 0; i <= 100; ++i) {
    const Bytes packet = sent_at(firmware, 0.01 * i);
    if (packet.empty()) continue;
    last = packet;
    most = std::max(most, 0.01 * part(packet, 0x06)[0]);
  }
  EXPECT_GT(most, 1.0);
  EXPECT_EQ(part(last, 0x01)[14], 3);  // over-current, both
  EXPECT_EQ(firmware.motors(), WheelSpeeds{});
}

}  // namespace
}  // namespace bw::emulators
