// Sub-payloads by hand.
#include "components/robot_base/kobuki/feedback.hpp"

#include <gtest/gtest.h>

#include "components/robot_base/kobuki/packet_reader.hpp"
#include "tests/components/robot_base/scripted_link.hpp"

namespace bw::kobuki {
namespace {

// Stamp 0x1234 = 4660 ms; bumper 4 left, drop 2 left, cliff 1 right; encoders FFFE = -2 and 0102 = 258; pwm
// -5 and 7; button 2; charger 22; 0xA1 = 161, 16.1 V; overcurrent right. Length 17 = 11. Checksum, pair by
// pair:
//   11^01=10, ^0F=1F, ^34=2B, ^12=39, ^04=3D, ^02=3F, ^01=3E, ^FE=C0, ^FF=3F, ^02=3D, ^01=3C, ^FB=C7, ^07=C0,
//   ^02=C2, ^16=D4, ^A1=75, ^02=77
TEST(KobukiFeedback, CoreByHand) {
  const Bytes bytes = {0xAA, 0x55, 0x11, 0x01, 0x0F, 0x34, 0x12, 0x04, 0x02, 0x01, 0xFE,
                       0xFF, 0x02, 0x01, 0xFB, 0x07, 0x02, 0x16, 0xA1, 0x02, 0x77};
  PacketReader reader;
  reader.add(bytes);
  const Feedback feedback = parse(reader.next());
  ASSERT_TRUE(feedback.core);
  const Core& core = *feedback.core;
  EXPECT_EQ(core.stamp, 4660);
  EXPECT_EQ(core.bumper, 4);
  EXPECT_EQ(core.wheel_drop, 2);
  EXPECT_EQ(core.cliff, 1);
  EXPECT_EQ(core.left_encoder, 65534);
  EXPECT_EQ(core.right_encoder, 258);
  EXPECT_EQ(core.left_pwm, -5);
  EXPECT_EQ(core.right_pwm, 7);
  EXPECT_EQ(core.buttons, 2);
  EXPECT_EQ(core.charger, 22);
  EXPECT_EQ(core.battery, 161);
  EXPECT_EQ(core.overcurrent, 2);
}

TEST(KobukiFeedback, StreamedOnesByHand) {
  const Feedback feedback = parse(Bytes{
      0x03, 3,  1,    2,    32,  // dock: near-left on the right one, near-centre, far-right
      0x04, 7,  0x18, 0xFC, 0x10, 0x27, 0,    0,    0,  // FC18 = -1000: -10.00 degrees; 2710 = 10000: 100.00 degrees/s
      0x05, 6,  0xFF, 0x0F, 0x00, 0x08, 0x01, 0x00,                                // 4095, 2048, 1
      0x06, 2,  30,   255,                                                         // 0.3 A, 2.55 A
      0x0D, 14, 9,    6,    1,    0,    2,    0,    0xFD, 0xFF, 4, 0, 5, 0, 6, 0,  // frame 9: (1, 2, -3), (4, 5, 6)
      0x10, 16, 5,    0,    0x01, 0x02, 3,    0,    4,    0,    5, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(feedback.dock->right, 1);
  EXPECT_EQ(feedback.dock->left, 32);
  EXPECT_EQ(feedback.inertia->angle, -1000);
  EXPECT_EQ(feedback.inertia->rate, 10'000);
  EXPECT_EQ(feedback.cliff->right, 4095);
  EXPECT_EQ(feedback.cliff->centre, 2048);
  EXPECT_EQ(feedback.cliff->left, 1);
  EXPECT_EQ(feedback.currents->left, 30);
  EXPECT_EQ(feedback.currents->right, 255);
  ASSERT_EQ(feedback.gyro->samples.size(), 2U);
  EXPECT_EQ(feedback.gyro->frame, 9);
  EXPECT_EQ(feedback.gyro->samples[0][2], -3);
  EXPECT_EQ(feedback.gyro->samples[1][0], 4);
  EXPECT_EQ(feedback.inputs->digital, 5);
  EXPECT_EQ(feedback.inputs->analog[0], 0x0201);
  EXPECT_EQ(feedback.skipped, 0);
}

TEST(KobukiFeedback, RequestedOnesByHand) {
  const Feedback feedback = parse(Bytes{0x0A, 4,  0,    4,    1, 0,  // 1.4.0
                                        0x0B, 2,  1,    2,           // an old board: patch 1, minor 2
                                        0x13, 12, 1,    0,    0, 0, 2,    0, 0, 0, 0xFF, 0, 0, 0x80, 0x15,
                                        13,   1,  0xA0, 0x86, 1, 0, 0x64, 0, 0, 0, 0xD0, 7, 0, 0});
  EXPECT_EQ(feedback.hardware->major, 1);
  EXPECT_EQ(feedback.hardware->minor, 4);
  EXPECT_EQ(feedback.firmware->minor, 2);
  EXPECT_EQ(feedback.firmware->major, 0);
  EXPECT_EQ((*feedback.id)[2], 0x800000FFU);
  EXPECT_TRUE(feedback.controller->is_user);
  EXPECT_EQ(feedback.controller->p, 100'000U);
  EXPECT_EQ(feedback.controller->i, 100U);
  EXPECT_EQ(feedback.controller->d, 2000U);
}

TEST(KobukiFeedback, WhatIsUnknownOrOfAnotherSizeIsSkippedByItsSize) {
  const Feedback feedback = parse(Bytes{0x77, 2, 1, 2, 0x01, 3, 1, 2, 3, 0x0D, 4, 0, 9, 1, 2, 0x06, 2, 1, 2});
  EXPECT_EQ(feedback.skipped, 3);
  EXPECT_FALSE(feedback.core);
  EXPECT_FALSE(feedback.gyro);
  ASSERT_TRUE(feedback.currents);
  EXPECT_EQ(feedback.currents->right, 2);
}

}  // namespace
}  // namespace bw::kobuki
