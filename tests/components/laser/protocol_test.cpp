// The words of the protocol against bytes made up by hand from its description.
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "components/laser/rplidar/answers.hpp"

namespace bw::laser {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Without payload: A5 and the command. With one: xor of all before. Full speed of an A2 in the maker's
// examples, 660 = 0294h:
// A5^F0 = 55, ^02 = 57, ^94 = C3, ^02 = C1. 600 rpm = 0258h: A5^A8 = 0D, ^02 = 0F, ^58 = 57, ^02 = 55.
TEST(RplidarProtocol, WritesRequests) {
  EXPECT_EQ(request(Command::stop), (Bytes{0xA5, 0x25}));
  EXPECT_EQ(request(Command::reset), (Bytes{0xA5, 0x40}));
  EXPECT_EQ(request(Command::scan), (Bytes{0xA5, 0x20}));
  EXPECT_EQ(request(Command::info), (Bytes{0xA5, 0x50}));
  EXPECT_EQ(request(Command::health), (Bytes{0xA5, 0x52}));
  EXPECT_EQ(request(Command::sample_times), (Bytes{0xA5, 0x59}));
  EXPECT_EQ(request(Command::motor_pwm, 660), (Bytes{0xA5, 0xF0, 0x02, 0x94, 0x02, 0xC1}));
  EXPECT_EQ(request(Command::motor_rpm, 600), (Bytes{0xA5, 0xA8, 0x02, 0x58, 0x02, 0x55}));
}

// Length 5 in bits 0..29, 1 in the upper two: 4000'0005h, little endian.
TEST(RplidarProtocol, ReadsHeaders) {
  EXPECT_EQ(read_header(Bytes{0xA5, 0x5A, 0x05, 0x00, 0x00, 0x40, 0x81}), AnswerType::nodes);
  EXPECT_EQ(read_header(Bytes{0xA5, 0x5A, 0x14, 0x00, 0x00, 0x00, 0x04}), AnswerType::info);
  EXPECT_EQ(read_header(Bytes{0xA5, 0x5A, 0x03, 0x00, 0x00, 0x00, 0x06}), AnswerType::health);
  EXPECT_EQ(read_header(Bytes{0xA5, 0x5A, 0x04, 0x00, 0x00, 0x00, 0x15}), AnswerType::sample_times);
}

TEST(RplidarProtocol, TakesNothingElseForAHeader) {
  EXPECT_EQ(read_header(Bytes{0xA5, 0x5A, 0x05, 0x00, 0x00, 0x40}), std::nullopt) << "too short";
  EXPECT_EQ(read_header(Bytes{0xA5, 0x5B, 0x05, 0x00, 0x00, 0x40, 0x81}), std::nullopt) << "no 5A";
  EXPECT_EQ(read_header(Bytes{0xA5, 0x5A, 0x05, 0x00, 0x00, 0x00, 0x81}), std::nullopt) << "no stream";
  EXPECT_EQ(read_header(Bytes{0xA5, 0x5A, 0x54, 0x00, 0x00, 0x40, 0x82}), std::nullopt) << "an express scan";
  EXPECT_EQ(read_header(Bytes{0xA5, 0x5A, 0x15, 0x00, 0x00, 0x00, 0x04}), std::nullopt) << "21 bytes of info";
  EXPECT_EQ(read_header(Bytes{0xA5, 0x5A, 0x14, 0x00, 0x00, 0x80, 0x04}), std::nullopt) << "mode 2";
}

// An A1: model 24 = 18h, firmware 1.29 as minor 1Dh, major 01h, hardware 7.
TEST(RplidarProtocol, ReadsWhoItIs) {
  AnswerReader reader;
  Bytes bytes = {0xA5, 0x5A, 0x14, 0x00, 0x00, 0x00, 0x04, 0x18, 0x1D, 0x01, 0x07};
  for (int i = 0; i < 16; ++i) bytes.push_back(static_cast<std::uint8_t>(0xA0 + i));
  const auto info = reader.read(bytes).info;
  ASSERT_TRUE(info);
  EXPECT_EQ(info->family(), Model::a1);
  EXPECT_EQ(info->text(),
            "a1 (model 24), firmware 1.29, hardware 7, serial number A0A1A2A3A4A5A6A7A8A9AAABACADAEAF");
}

// Upper four bits of the model: 1 A1, 2 A2, 3 A3, 4 C1, 6 to 8 S; 14 is none.
TEST(RplidarProtocol, KnowsFamilies) {
  EXPECT_EQ(Info{.model = 0x18}.family(), Model::a1);
  EXPECT_EQ(Info{.model = 0x28}.family(), Model::a2);
  EXPECT_EQ(Info{.model = 0x31}.family(), Model::a3);
  EXPECT_EQ(Info{.model = 0x41}.family(), Model::c1);
  EXPECT_EQ(Info{.model = 0x61}.family(), Model::s);
  EXPECT_EQ(Info{.model = 0xE1}.family(), std::nullopt);
}

// Warning 8002h; sample times 500 us = 01F4h and 250 us = 00FAh, of which the standard scan's is the first.
TEST(RplidarProtocol, ReadsHealthAndSampleTimes) {
  AnswerReader reader;
  const auto& sick = reader.read(Bytes{0xA5, 0x5A, 0x03, 0x00, 0x00, 0x00, 0x06, 0x01, 0x02, 0x80});
  ASSERT_TRUE(sick.health);
  EXPECT_EQ(sick.health->status, Health::Status::warning);
  EXPECT_EQ(sick.health->code, 0x8002);
  EXPECT_FALSE(reader.read(Bytes{0xA5, 0x5A, 0x03, 0x00, 0x00, 0x00, 0x06, 0x03, 0x00, 0x00}).health);
  const auto& times = reader.read(Bytes{0xA5, 0x5A, 0x04, 0x00, 0x00, 0x00, 0x15, 0xF4, 0x01, 0xFA, 0x00});
  ASSERT_TRUE(times.sample_time);
  EXPECT_EQ(times.sample_time->nanoseconds, 500'000);
}

// Start, quality 15: 0Fh << 2 | 1 = 3Dh. 90.5 degrees: 5792 = 16A0h, << 1 | 1 = 2D41h. 2 m: 8000 = 1F40h.
// Not a start, quality 0: 02h. 359.984375 degrees = 23039 / 64: 59FFh, << 1 | 1 = B3FFh. Nothing measured: 0.
TEST(RplidarProtocol, ReadsNodes) {
  AnswerReader reader;
  const auto& received = reader.read(Bytes{0xA5, 0x5A, 0x05, 0x00, 0x00, 0x40, 0x81,  //
                                           0x3D, 0x41, 0x2D, 0x40, 0x1F});
  EXPECT_TRUE(received.scan_begins);
  ASSERT_EQ(received.nodes.size(), 1U);
  EXPECT_EQ(received.nodes[0],
            (Node{.starts_revolution = true, .quality = 15, .angle_q6 = 5792, .range_q2 = 8000}));
  EXPECT_NEAR(received.nodes[0].angle(), 90.5 * std::numbers::pi / 180.0, 1e-12);
  EXPECT_FLOAT_EQ(received.nodes[0].range(), 2.0F);
  const Bytes last = {0x02, 0xFF, 0xB3, 0x00, 0x00};
  EXPECT_EQ(read_node(std::span<const std::uint8_t, kNodeSize>(last)),
            (Node{.starts_revolution = false, .quality = 0, .angle_q6 = 23039, .range_q2 = 0}));
}

TEST(RplidarProtocol, RefusesNodesThatAreNone) {
  const auto read = [](Bytes bytes) { return read_node(std::span<const std::uint8_t, kNodeSize>(bytes)); };
  EXPECT_FALSE(read({0x3F, 0x41, 0x2D, 0x40, 0x1F})) << "starts, and does not";
  EXPECT_FALSE(read({0x3C, 0x41, 0x2D, 0x40, 0x1F})) << "neither";
  EXPECT_FALSE(read({0x3D, 0x40, 0x2D, 0x40, 0x1F})) << "check bit";
  EXPECT_FALSE(read({0x3D, 0xFF, 0xFF, 0x40, 0x1F})) << "512 degrees";
}

// In pieces of one byte, with noise before each answer.
TEST(RplidarProtocol, FindsAnswersInNoiseByteByByte) {
  AnswerReader reader;
  Bytes bytes = {0x00, 0xA5, 0xA5, 0x5A, 0x13};  // 5
  bytes.insert(bytes.end(), {0xA5, 0x5A, 0x03, 0x00, 0x00, 0x00, 0x06, 0x00, 0x00, 0x00});
  bytes.insert(bytes.end(), {0xA5});  // 1
  bytes.insert(bytes.end(), {0xA5, 0x5A, 0x05, 0x00, 0x00, 0x40, 0x81, 0x3D, 0x41, 0x2D, 0x40, 0x1F});
  int healths = 0;
  int nodes = 0;
  for (const std::uint8_t byte : bytes) {
    const Received& received = reader.read(std::span(&byte, 1));
    healths += received.health ? 1 : 0;
    nodes += static_cast<int>(received.nodes.size());
  }
  EXPECT_EQ(healths, 1);
  EXPECT_EQ(nodes, 1);
  EXPECT_EQ(reader.bytes_thrown_away(), 6U);
}

}  // namespace
}  // namespace bw::laser
