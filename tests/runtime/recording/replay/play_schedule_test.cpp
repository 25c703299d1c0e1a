// When what is due, reckoned by hand: bag times begin at 100 s, the steady clock at 7 s.
#include "runtime/recording/replay/play_schedule.hpp"

#include <vector>

#include <gmock/gmock.h>

namespace bw::replay {
namespace {

using What = PlayStep::What;

constexpr Time kStart{100'000'000'000};
constexpr Duration kNow{7'000'000'000};

Duration ms(std::int64_t n) { return Duration::milliseconds(n); }

TEST(PlaySchedule, AMessageIsDueWhenTheBagsTimeHasPassed) {
  PlaySchedule schedule({.start = kStart}, kNow);
  const PlayStep early = schedule.next(kStart + ms(250), kNow);
  EXPECT_EQ(early.what, What::wait);
  EXPECT_EQ(early.until, kNow + ms(250));
  EXPECT_EQ(schedule.next(kStart + ms(250), kNow + Duration{249'999'999}).what, What::wait);
  EXPECT_EQ(schedule.next(kStart + ms(250), kNow + ms(250)).what, What::message);
  const PlayStep late = schedule.next(kStart + ms(250), kNow + ms(253));
  EXPECT_EQ(late.what, What::message);
  EXPECT_EQ(late.late, ms(3));
}

TEST(PlaySchedule, TheRateDividesTheWaits) {
  for (const auto& [rate, wait] :
       {std::pair(2.0, ms(500)), std::pair(0.5, ms(2000)), std::pair(1000.0, ms(1))}) {
    PlaySchedule schedule({.start = kStart, .rate = rate}, kNow);
    EXPECT_EQ(schedule.next(kStart + ms(1000), kNow).until, kNow + wait) << rate;
  }
}

TEST(PlaySchedule, NothingAddsUpOverAnHour) {
  // Each of 3600 000 messages is due at its own time from the beginning, however late the one before it came.
  PlaySchedule schedule({.start = kStart, .rate = 3.0}, kNow);
  for (std::int64_t i = 1; i <= 3'600'000; i += 1733) {
    const auto until = schedule.next(kStart + ms(i), kNow).until;
    ASSERT_TRUE(until);
    EXPECT_NEAR(static_cast<double>((*until - kNow).nanoseconds), static_cast<double>(i) * 1e6 / 3.0, 1.0);
  }
}

TEST(PlaySchedule, WhileItIsPausedTimeStands) {
  PlaySchedule schedule({.start = kStart}, kNow);
  schedule.set_paused(true, kNow + ms(100));
  const PlayStep step = schedule.next(kStart + ms(101), kNow + ms(5000));
  EXPECT_EQ(step.what, What::wait);
  EXPECT_FALSE(step.until);
  EXPECT_EQ(schedule.position(kNow + ms(5000)), kStart + ms(100));
  schedule.set_paused(false, kNow + ms(9000));
  EXPECT_EQ(schedule.next(kStart + ms(101), kNow + ms(9000)).until, kNow + ms(9001));
}

TEST(PlaySchedule, AStepGivesOneMessageAndTheTimeGoesOnFromThere) {
  PlaySchedule schedule({.start = kStart, .is_paused = true}, kNow);
  EXPECT_EQ(schedule.next(kStart + ms(500), kNow).what, What::wait);
  schedule.step();
  EXPECT_EQ(schedule.next(kStart + ms(500), kNow + ms(1)).what, What::message);
  EXPECT_EQ(schedule.position(kNow + ms(2)), kStart + ms(500));
  EXPECT_EQ(schedule.next(kStart + ms(600), kNow + ms(3)).what, What::wait);
  schedule.set_paused(false, kNow + ms(10));
  EXPECT_EQ(schedule.next(kStart + ms(600), kNow + ms(10)).until, kNow + ms(110));
}

TEST(PlaySchedule, ANewRateHoldsFromNowOn) {
  PlaySchedule schedule({.start = kStart}, kNow);
  schedule.set_rate(2.0, kNow + ms(1000));
  // 1 s of the bag is over; the second one takes 0.5 s.
  EXPECT_EQ(schedule.next(kStart + ms(2000), kNow + ms(1000)).until, kNow + ms(1500));
  EXPECT_EQ(schedule.position(kNow + ms(1500)), kStart + ms(2000));
}

TEST(PlaySchedule, AtRateZeroEverythingIsDueUnlessItIsPaused) {
  PlaySchedule schedule({.start = kStart, .rate = 0.0}, kNow);
  EXPECT_EQ(schedule.next(kStart + ms(3'600'000), kNow).what, What::message);
  EXPECT_EQ(schedule.position(kNow), kStart + ms(3'600'000));
  schedule.set_rate(1.0, kNow);
  EXPECT_EQ(schedule.rate(), 0.0);
  schedule.set_paused(true, kNow);
  EXPECT_EQ(schedule.next(kStart + ms(3'600'001), kNow).what, What::wait);
  schedule.step();
  EXPECT_EQ(schedule.next(kStart + ms(3'600'001), kNow).what, What::message);
}

/// What comes within `length` when every wait is slept to its end: bag times in ms, of clock ticks negative.
std::vector<std::int64_t> played(PlaySchedule& schedule, std::vector<std::int64_t> messages_ms,
                                 Duration length) {
  std::vector<std::int64_t> all;
  Duration now = kNow;
  for (std::size_t i = 0; i < messages_ms.size();) {
    const Time message = kStart + ms(messages_ms[i]);
    const PlayStep step = schedule.next(message, now);
    if (step.what == What::message) {
      all.push_back(messages_ms[i++]);
    } else if (step.what == What::clock) {
      all.push_back(-((schedule.position(now) - kStart).nanoseconds / 1'000'000));
    } else {
      now = step.until.value();
      if (now - kNow > length) break;
    }
  }
  return all;
}

TEST(PlaySchedule, TheClockTicksInBetween) {
  // 40 Hz of the wall; at rate 2 each tick is 50 ms of the bag.
  PlaySchedule schedule({.start = kStart, .rate = 2.0, .clock_hz = 40.0}, kNow);
  EXPECT_THAT(played(schedule, {10, 60, 120, 130}, ms(1000)),
              testing::ElementsAre(0, 10, -50, 60, -100, 120, 130));
}

TEST(PlaySchedule, TheClockTicksOnWhileItIsPausedAndShowsTheSameTime) {
  PlaySchedule schedule({.start = kStart, .clock_hz = 40.0, .is_paused = true}, kNow);
  EXPECT_THAT(played(schedule, {10}, ms(100)),
              testing::ElementsAre(0, 0, 0, 0, 0));  // at 0, 25, 50, 75, 100 ms
}

TEST(PlaySchedule, MissedTicksBecomeOne) {
  PlaySchedule schedule({.start = kStart, .clock_hz = 40.0}, kNow);
  const Time message = kStart + ms(10'000);
  EXPECT_EQ(schedule.next(message, kNow + ms(990)).what, What::clock);
  const PlayStep step = schedule.next(message, kNow + ms(990));
  EXPECT_EQ(step.what, What::wait);
  EXPECT_EQ(step.until, kNow + ms(1000));
}

TEST(PlaySchedule, AtRateZeroTheClockGoesByTheBag) {
  PlaySchedule schedule({.start = kStart, .rate = 0.0, .clock_hz = 10.0}, kNow);
  // The first at once, then one for each 100 ms of the bag that has passed.
  EXPECT_THAT(played(schedule, {0, 50, 100, 120, 500}, ms(1000)),
              testing::ElementsAre(0, 0, 50, -100, 100, 120, -500, 500));
}

}  // namespace
}  // namespace bw::replay
