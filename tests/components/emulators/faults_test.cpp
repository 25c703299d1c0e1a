// What faults do to bodies, wheels and bytes.
#include <algorithm>
#include <bit>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/emulators/faulty_line.hpp"

namespace bw::emulators {
namespace {

using ::testing::ElementsAre;
using Bytes = std::vector<std::uint8_t>;

const Bytes kSent = {0xAA, 0x55, 0x01, 0x02, 0x03, 0x04};

Bytes passed(const Faults& faults, std::uint64_t seed = 1) {
  FaultyLine line(seed);
  const auto bytes = line.pass(kSent, faults);
  return {bytes.begin(), bytes.end()};
}

TEST(Faults, SpoilWhatIsSent) {
  EXPECT_EQ(passed({}), kSent);
  EXPECT_TRUE(passed({.silent = true}).empty());
  EXPECT_TRUE(passed({.cable_pulled = true}).empty());
  EXPECT_THAT(passed({.half_frames = true}), ElementsAre(0xAA, 0x55, 0x01));
  const Bytes garbage = passed({.garbage = true});
  EXPECT_EQ(garbage.size(), kSent.size());
  EXPECT_NE(garbage, kSent);
  const Bytes corrupt = passed({.corrupt = true});
  int bits = 0;
  for (std::size_t i = 0; i < kSent.size(); ++i)
    bits += std::popcount(static_cast<unsigned>(kSent[i] ^ corrupt[i]));
  EXPECT_EQ(bits, 1);
}

TEST(Faults, ChangeWhatTheBoardSees) {
  const Body body{.left_ticks = std::numeric_limits<std::int32_t>::max(), .right_ticks = 7};
  const Body seen = seen_with(body, {.tick_jump = 1,
                                     .clock_jump = -2.5,
                                     .cliff_left = true,
                                     .drop_right = true,
                                     .battery_voltage = 13.0,
                                     .charger = Charger::dock,
                                     .buttons = 4});
  EXPECT_EQ(seen.left_ticks, std::numeric_limits<std::int32_t>::min());  // they wrap
  EXPECT_EQ(seen.right_ticks, 8);
  EXPECT_EQ(seen.contacts, (ContactReading{.cliff_left = true, .drop_right = true}));
  EXPECT_EQ(seen.clock_offset, Duration::milliseconds(-2500));
  EXPECT_EQ(seen.battery_voltage, 13.0);
  EXPECT_EQ(seen.charger, Charger::dock);
  EXPECT_EQ(seen.buttons, 4U);
}

TEST(Faults, HoldOrDriveWheels) {
  EXPECT_EQ(with_faults({0.2, 0.3}, {}), (WheelSpeeds{0.2, 0.3}));
  EXPECT_EQ(with_faults({0.2, 0.3}, {.runaway_left = -0.5, .stalled_right = true}), (WheelSpeeds{-0.5, 0.0}));
}

}  // namespace
}  // namespace bw::emulators
