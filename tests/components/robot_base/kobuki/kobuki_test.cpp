// The driver on a cable whose other end the test holds.
#include "components/robot_base/kobuki/kobuki.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/components/robot_base/kobuki/packets.hpp"

namespace bw::kobuki {
namespace {

using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

const Bytes kStop = {0xAA, 0x55, 0x06, 0x01, 0x04, 0x00, 0x00, 0x00, 0x00, 0x03};
const Bytes kAhead = {0xAA, 0x55, 0x06, 0x01, 0x04, 0xC8, 0x00, 0x00, 0x00, 0xCB};  // 0.2 m/s

class KobukiOnACable : public testing::Test {
 protected:
  /// 10 ms: what is waiting is read, `wheels` are commanded.
  Readings step(const WheelSpeeds& wheels = {}) {
    now_ = now_ + Duration::milliseconds(10);
    wire_.from_host.clear();
    Readings readings = kobuki_.poll(now_);
    took_ = kobuki_.command(now_, wheels);
    for (const EncoderCounts& counts : readings.counts) counts_.push_back(counts);
    return readings;
  }
  /// A packet and two steps.
  Readings packet_and_steps(Said said, const WheelSpeeds& wheels = {}) {
    said.stamp = stamp_ += 20;
    wire_.put(whole_packet(said));
    const Readings readings = step(wheels);
    step(wheels);
    return readings;
  }
  void recognise() {
    for (int i = 0; i < 5; ++i) packet_and_steps({});
  }

  ScriptedLink::Wire wire_;
  Kobuki kobuki_{{}, {0.035, 0.035}, std::make_unique<ScriptedLink>(wire_)};
  Time now_ = Time::seconds(100.0);
  int stamp_ = 0;
  bool took_ = false;
  std::vector<EncoderCounts> counts_;
};

TEST_F(KobukiOnACable, TheFirstFrameAfterEachOpeningIsAStop) {
  for (int opening = 0; opening < 3; ++opening) {
    step({0.2, 0.2});
    ASSERT_FALSE(wire_.from_host.empty());
    EXPECT_THAT(wire_.from_host, Each(kStop));
    EXPECT_FALSE(took_);
    for (int i = 0; i < 5; ++i) packet_and_steps({}, {0.2, 0.2});
    packet_and_steps({}, {0.2, 0.2});
    EXPECT_TRUE(took_);
    wire_.pull();
    EXPECT_FALSE(step({0.2, 0.2}).link.is_open);
    wire_.plug_in();
  }
}

TEST_F(KobukiOnACable, AnswersEachPacketWithTheNewestCommand) {
  recognise();
  wire_.put(whole_packet({.stamp = stamp_ += 20}));
  step({0.2, 0.2});
  EXPECT_THAT(wire_.from_host, Contains(kAhead).Times(1));
  step({0.3, 0.3});  // no packet since
  EXPECT_TRUE(wire_.from_host.empty());
  wire_.put(whole_packet({.stamp = stamp_ += 20}));
  step({0.2, 0.2});
  EXPECT_THAT(wire_.from_host, Contains(kAhead).Times(1));
  step({});  // a stop does not wait for the next packet
  EXPECT_THAT(wire_.from_host, Contains(kStop).Times(1));
}

// The other direction of the cable may still work.
TEST_F(KobukiOnACable, GoesOnCommandingABaseThatIsSilent) {
  recognise();
  int written = 0;
  for (int i = 0; i < 30; ++i) {
    step();
    for (const Bytes& bytes : wire_.from_host) written += bytes == kStop ? 1 : 0;
  }
  EXPECT_EQ(written, 10);  // 300 ms, one each 30 ms
}

// 100 ms without a packet; the one at the 10th step is 100 ms old.
TEST_F(KobukiOnACable, SilenceIsALostLink) {
  recognise();  // the newest packet came 10 ms ago
  for (int i = 0; i < 8; ++i) EXPECT_TRUE(step().link.is_open) << i;
  const Readings readings = step();
  EXPECT_FALSE(readings.link.is_open);
  EXPECT_THAT(readings.link.fault, HasSubstr("switched on"));
  EXPECT_EQ(readings.link.openings, 1U);
  EXPECT_TRUE(packet_and_steps({}).link.is_open);
}

TEST_F(KobukiOnACable, CountsGoOnThroughWrapsForwardAndBack) {
  int left = 65'500, right = 30;
  for (int i = 0; i < 600; ++i) {
    left += 160;
    right -= 160;
    packet_and_steps({.left = left & 0xFFFF, .right = right & 0xFFFF});
  }
  ASSERT_EQ(counts_.size(), 600U);
  EXPECT_EQ(counts_.back().left - counts_.front().left, 160 * 599);
  EXPECT_EQ(counts_.back().right - counts_.front().right, -160 * 599);
  // 599 periods of 20 ms, and up to kDriftMax more.
  EXPECT_NEAR((counts_.back().time - counts_.front().time).to_seconds(), 11.98, 0.02);
}

TEST_F(KobukiOnACable, TellsWhatIsTouchedBetweenTwoLooks) {
  recognise();
  wire_.put(whole_packet({.stamp = stamp_ += 20, .bumper = 4, .drop = 1, .buttons = 2}));
  wire_.put(whole_packet({.stamp = stamp_ += 20, .bumper = 2, .cliff = 1, .buttons = 1}));
  const Readings readings = step();
  ASSERT_TRUE(readings.contacts);
  EXPECT_EQ(
      *readings.contacts,
      (ContactReading{.bumper_left = true, .bumper_centre = true, .cliff_right = true, .drop_right = true}));
  EXPECT_EQ(readings.buttons, 3U);
  EXPECT_EQ(packet_and_steps({.drop = 2}).contacts, (ContactReading{.drop_left = true}));
  EXPECT_EQ(packet_and_steps({.cliff = 6}).contacts,
            (ContactReading{.cliff_left = true, .cliff_centre = true}));
}

TEST_F(KobukiOnACable, BatteryChargerAndCurrents) {
  // (14.85 - 13.2) / (16.5 - 13.2) is a half; 14.8 V: 1.6 / 3.3.
  const Readings readings = packet_and_steps({.battery = 148, .overcurrent = 1});
  EXPECT_NEAR(readings.battery->voltage, 14.8, 1e-9);
  EXPECT_NEAR(readings.battery->charge, 1.6 / 3.3, 1e-9);
  EXPECT_NEAR(readings.currents->left, 0.10, 1e-9);
  EXPECT_NEAR(readings.currents->right, 0.12, 1e-9);
  EXPECT_TRUE(readings.currents->is_over_left);
  EXPECT_FALSE(readings.currents->is_over_right);
  struct Case {
    std::uint8_t charger;
    bool is_plugged, is_charging;
  };
  for (const Case& c : {Case{0, false, false}, Case{2, true, false}, Case{6, true, true},
                        Case{18, true, false}, Case{22, true, true}, Case{7, true, false}}) {
    const Readings charged = packet_and_steps({.charger = c.charger});
    EXPECT_EQ(charged.battery->is_plugged, c.is_plugged) << int{c.charger};
    EXPECT_EQ(charged.battery->is_charging, c.is_charging) << int{c.charger};
  }
}

// 175.00 degrees is the zero; -179.00 is 6 degrees on, 170.00 is 5 back of the zero.
TEST_F(KobukiOnACable, TheGyroCountsFromItsFirstAngleAndThroughTheTurn) {
  const auto heading_at = [&](int centidegrees, int rate) {
    wire_.put(packet(joined({core_payload({.stamp = stamp_ += 20}), inertia_payload(centidegrees, rate)})));
    return step().gyro.at(0);
  };
  constexpr double kDegree = std::numbers::pi / 180.0;
  EXPECT_EQ(heading_at(17'500, 0).angle, 0.0);
  EXPECT_NEAR(heading_at(-17'900, 4'500).angle, 6.0 * kDegree, 1e-9);
  const GyroReading back = heading_at(17'000, -1'000);
  EXPECT_NEAR(back.angle, -5.0 * kDegree, 1e-9);
  EXPECT_NEAR(back.rate, -10.0 * kDegree, 1e-9);
}

TEST_F(KobukiOnACable, RawGyroStandsInForTheInertia) {
  // z of the two samples: 3 and 6, their mean 4.5 * 0.00875 degrees/s.
  wire_.put(packet(joined({core_payload({}), {0x0D, 14, 7, 6, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0}})));
  const GyroReading gyro = step().gyro.at(0);
  EXPECT_NEAR(gyro.rate, 4.5 * 0.00875 * std::numbers::pi / 180.0, 1e-12);
  EXPECT_TRUE(std::isnan(gyro.angle));
}

// 400 ticks in 20 ms are more than wheels do; as many in 80 ms are not.
TEST_F(KobukiOnACable, TicksThatJumpAreCountedAndToldForASecond) {
  recognise();
  stamp_ += 60;
  for (int i = 0; i < 6; ++i) step();
  packet_and_steps({.left = 1600, .right = 1600});
  EXPECT_EQ(kobuki_.counters().at("encoder jumps"), 0U);
  const Readings jump = packet_and_steps({.left = 2001, .right = 1600});
  EXPECT_EQ(kobuki_.counters().at("encoder jumps"), 1U);
  EXPECT_THAT(jump.fault, HasSubstr("jumped by 401 in 20 ms"));
  // What goes on is one news: its first text.
  EXPECT_THAT(packet_and_steps({.left = 2801, .right = 1600}).fault, HasSubstr("jumped by 401 in 20 ms"));
  for (int i = 0; i < 49; ++i) EXPECT_NE(packet_and_steps({.left = 2801, .right = 1600}).fault, "");
  packet_and_steps({.left = 2801, .right = 1600});
  EXPECT_EQ(packet_and_steps({.left = 2801, .right = 1600}).fault, "");
}

// Stamp and counters begin at zero: what the wheels rotated is not known, and is left out.
TEST_F(KobukiOnACable, ABoardThatRestartsIsToldAndItsCountsGoOn) {
  for (int i = 0; i < 50; ++i) packet_and_steps({.left = 100 * i, .right = 100 * i});
  stamp_ = 0;
  const Readings readings = packet_and_steps({.left = 10, .right = 10});
  EXPECT_THAT(readings.fault, HasSubstr("restarted"));
  EXPECT_EQ(kobuki_.counters().at("clock jumps"), 1U);
  EXPECT_EQ(counts_.back().left, counts_.at(counts_.size() - 2).left);
  packet_and_steps({.left = 60, .right = 60});
  EXPECT_EQ(counts_.back().left - counts_.at(counts_.size() - 2).left, 50);
}

TEST_F(KobukiOnACable, AsksForVersionsUntilTheyAreTold) {
  const Bytes request = {0xAA, 0x55, 0x04, 0x09, 0x02, 0x0B, 0x00, 0x04};
  const auto requests = [&](int packets) {
    int count = 0;
    for (int i = 0; i < packets; ++i) {
      wire_.put(whole_packet({.stamp = stamp_ += 20}));
      step();
      for (const Bytes& bytes : wire_.from_host) count += bytes == request ? 1 : 0;
      step();
    }
    return count;
  };
  EXPECT_EQ(requests(111), 3);  // recognised at the second packet; at once, after 1 s, after 2 s
  wire_.put(packet({0x0A, 4, 0, 4, 1, 0, 0x0B, 4, 1, 2, 1, 0}));
  step();
  EXPECT_EQ(kobuki_.counters().at("firmware version"), 10'201U);
  EXPECT_EQ(kobuki_.counters().at("hardware version"), 10'400U);
  EXPECT_EQ(requests(200), 0);
}

TEST(Kobuki, GainsAreGivenUntilTheBoardHasThem) {
  ScriptedLink::Wire wire;
  KobukiOptions options;
  options.gains.is_set = true;
  Kobuki kobuki(options, {0.035, 0.035}, std::make_unique<ScriptedLink>(wire));
  const auto gains_written = [&](int from, int to, const Bytes& more) {
    int count = 0;
    for (int i = from; i < to; ++i) {
      wire.put(whole_packet({.stamp = 20 * i}));
      wire.put(more);
      wire.from_host.clear();
      kobuki.poll(Time::seconds(10.0 + 0.02 * i));
      kobuki.command(Time::seconds(10.0 + 0.02 * i), {});
      for (const Bytes& bytes : wire.from_host) count += bytes == set_user_gains({}) ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(gains_written(0, 60, {}), 2);  // at 0.02 s and 1.02 s
  gains_written(60, 61, packet({0x15, 13, 1, 0xA0, 0x86, 1, 0, 0x64, 0, 0, 0, 0xD0, 7, 0, 0}));
  EXPECT_EQ(gains_written(61, 200, {}), 0);
}

TEST_F(KobukiOnACable, ADeviceThatIsNoKobukiIsToldInWords) {
  for (int i = 0; i < 60; ++i) {
    wire_.put("ERROR\r");
    step({0.2, 0.2});
    EXPECT_THAT(wire_.from_host, Each(kStop));
  }
  wire_.put("ERROR\r");
  const Readings readings = step({0.2, 0.2});
  EXPECT_FALSE(readings.link.is_open);
  EXPECT_THAT(readings.fault, HasSubstr("Parallax Eddie"));
  EXPECT_FALSE(took_);
  for (int i = 0; i < 150; ++i) {
    if (wire_.state.is_open) wire_.put("ERROR\r");
    step();
  }
  EXPECT_THAT(wire_.closed_because, HasSubstr("no packet of a Kobuki, but bytes"));
}

TEST_F(KobukiOnACable, TheWrongSpeedOfTheLineIsToldInWords) {
  Readings readings;
  for (int i = 0; i < 70; ++i) {
    wire_.put(Bytes{0xF8, 0x00, 0x80, 0x1E, 0xFE});
    readings = step();
  }
  EXPECT_THAT(readings.fault, HasSubstr("another speed of the line"));
  EXPECT_EQ(kobuki_.counters().at("bytes thrown away"), 350U);
}

TEST_F(KobukiOnACable, AfterALongPauseWrapsAreToldToBeUnknown) {
  recognise();
  for (int i = 0; i < 500; ++i) step();
  stamp_ += 5000;
  const Readings readings = packet_and_steps({.left = 100, .right = 100});
  EXPECT_THAT(readings.warning, HasSubstr("whole wraps"));
  EXPECT_EQ(readings.fault, "");
  EXPECT_EQ(counts_.back().left, 100);
}

TEST_F(KobukiOnACable, StopWritesAtOnceAndToleratesAMissingCable) {
  recognise();
  packet_and_steps({}, {0.2, 0.2});
  wire_.from_host.clear();
  kobuki_.stop(now_);
  EXPECT_THAT(wire_.from_host, Contains(kStop).Times(1));
  wire_.pull();
  kobuki_.stop(now_);
  EXPECT_EQ(wire_.from_host.size(), 1U);
}

// The firmware goes by wheels of 35 mm. On wheels of 40 and 28 mm, 0.2 m/s are 175 and 250 mm/s to it: v =
// 212.5 mm/s, w = 75 / 230 rad/s, r = 651.67 mm, (r + 115) * w = 250 mm/s.
TEST(Kobuki, WheelsOfAnotherSizeAreToldOtherSpeeds) {
  ScriptedLink::Wire wire;
  Kobuki kobuki({}, {0.040, 0.028}, std::make_unique<ScriptedLink>(wire));
  for (int i = 0; i < 3; ++i) {
    wire.put(whole_packet({.stamp = 20 * i}));
    kobuki.poll(Time::seconds(10.0 + 0.02 * i));
    kobuki.command(Time::seconds(10.0 + 0.02 * i), {0.2, 0.2});
  }
  EXPECT_EQ(wire.from_host.back(), base_control({250, 651}));
}

TEST_F(KobukiOnACable, AWriteThatFailsIsSaid) {
  recognise();
  wire_.refuses = true;
  wire_.put(whole_packet({.stamp = stamp_ += 20}));
  step({0.2, 0.2});
  EXPECT_FALSE(took_);
}

}  // namespace
}  // namespace bw::kobuki
