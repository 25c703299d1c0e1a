#include "runtime/host/writer_clock.hpp"

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

namespace bw {
namespace {

using Reach = WriterClock::Reach;

/// Vendor, host, the rest of the participant, entity.
dds::Guid guid(std::uint8_t vendor, std::uint8_t host, std::uint8_t participant) {
  return {0x01, vendor, host, 7, participant, 1, 2, 3, 4, 5, 6, 7, 0, 0, 1, 3};
}
constexpr std::uint8_t kFast = 0x0f, kCyclone = 0x10;
const dds::Guid kReader = guid(kFast, 1, 1);

TEST(WriterClock, WhereOnlyLoopbackIsHeardEveryVendorIsOfThisHost) {
  const WriterClock clock(Reach::this_host);
  EXPECT_TRUE(clock.is_own(guid(kCyclone, 9, 2), kReader));
  EXPECT_TRUE(clock.is_own(guid(kFast, 1, 2), kReader));
}

TEST(WriterClock, OnANetworkTheGuidTellsTheHostAndOthersVendorsDoNotTell) {
  const WriterClock clock(Reach::network);
  EXPECT_TRUE(clock.is_own(guid(kFast, 1, 2), kReader));
  EXPECT_FALSE(clock.is_own(guid(kFast, 2, 2), kReader));
  EXPECT_FALSE(clock.is_own(guid(kCyclone, 1, 2), kReader));
}

// Row 12 of the faults.
TEST(WriterClock, AfterTheSystemClockWasSetOnlyThisProcessIsOfItsOwnClock) {
  for (const Duration step : {Duration::milliseconds(-3'600'000), Duration::milliseconds(6)}) {
    WriterClock clock(Reach::this_host, Duration::milliseconds(1000));
    EXPECT_EQ(clock.look(Duration::milliseconds(1004)),
              std::nullopt);  // two clocks are read one after the other
    EXPECT_TRUE(clock.is_own(guid(kFast, 1, 2), kReader));
    EXPECT_EQ(clock.look(Duration::milliseconds(1000) + step), step);
    EXPECT_EQ(clock.look(Duration::milliseconds(1000) + step), std::nullopt);
    EXPECT_FALSE(clock.is_own(guid(kFast, 1, 2), kReader));
    EXPECT_TRUE(clock.is_own(guid(kFast, 1, 1), kReader));
    clock.look(Duration::milliseconds(1000));  // set back: those who started meanwhile are still apart
    EXPECT_FALSE(clock.is_own(guid(kFast, 1, 2), kReader));
  }
}

TEST(WriterClock, InLockStepAndByClockThereIsOneClock) {
  WriterClock clock(Reach::one_clock);
  EXPECT_EQ(clock.look(Duration::milliseconds(3'600'000)), std::nullopt);
  EXPECT_TRUE(clock.is_own(guid(kCyclone, 2, 2), kReader));
}

TEST(WriterClock, TheOffsetOfTheSystemClockStaysWhereItIs) {
  const Duration change = system_clock_offset() - system_clock_offset();
  EXPECT_LT(std::abs(change.to_seconds()), 5e-3);
}

}  // namespace
}  // namespace bw
