// One process that is looked after, in virtual time: what is done when, by the limits of SupervisionLimits.
#include "runtime/supervisor/supervised_process.hpp"

#include <vector>

#include <gmock/gmock.h>

namespace bw {
namespace {

using testing::HasSubstr;
using Act = SupervisedProcess::Act;
using State = SupervisedProcess::State;

constexpr int kKilled = 128 + 9;

Duration at(double seconds) { return Duration::seconds(seconds); }
Notification said(const std::string& text) { return parse_notification(text); }

/// One that was started at 0 s and is up at 0.3 s.
struct Up {
  Up() {
    EXPECT_EQ(process.next(at(0.0)), Act::start);
    process.started(at(0.0));
    process.heard(said("READY=1\nSTATUS=9 nodes are up"), at(0.3));
    EXPECT_EQ(process.state(), State::up);
  }
  SupervisedProcess process;
};

TEST(SupervisedProcess, OneThatSaysThatItsEndTakesTimeGetsIt) {
  Up up;
  up.process.heard(said("STOPPING=1\nX_BANDWAGON_OVER=1"), at(10.0));
  up.process.heard(said("EXTEND_TIMEOUT_USEC=60000000"), at(12.0));
  EXPECT_EQ(up.process.next(at(30.0)), Act::nothing);
  EXPECT_EQ(up.process.next(at(71.9)), Act::nothing);
  EXPECT_EQ(up.process.next(at(72.1)), Act::kill);
  for (const char* text : {"EXTEND_TIMEOUT_USEC=", "EXTEND_TIMEOUT_USEC=-1", "EXTEND_TIMEOUT_USEC=1s"})
    EXPECT_FALSE(said(text).extended) << text;
  EXPECT_EQ(said("EXTEND_TIMEOUT_USEC=999999999999").extended, Duration::seconds(600.0))
      << "ten minutes at most";
}

TEST(Notification, IsReadLineByLineAndWhatIsUnknownMeansNothing) {
  const Notification all = said("READY=1\nFDSTORE=1\nSTATUS=a=b\nWATCHDOG=1\nSTOPPING=1\nX_BANDWAGON_OVER=1");
  EXPECT_TRUE(all.is_ready && all.is_alive && all.is_stopping && all.is_over && !all.hangs);
  EXPECT_EQ(all.status, "a=b");
  const Notification none = said("READY=10\nWATCHDOG\n\n\nSTATUS\nready=1");
  EXPECT_FALSE(none.is_ready || none.is_alive || none.is_stopping || none.is_over || none.hangs ||
               none.status);
  EXPECT_TRUE(said("WATCHDOG=trigger").hangs);
}

TEST(SupervisedProcess, TellsHowLongItTookToBeUp) {
  const Up up;
  EXPECT_EQ(up.process.time_to_ready(), at(0.3));
  EXPECT_EQ(up.process.status(), "9 nodes are up");
}

TEST(SupervisedProcess, OneWithoutASignOfLifeIsKilledOnce) {
  Up up;
  up.process.heard(said("WATCHDOG=1"), at(1.0));
  EXPECT_EQ(up.process.next(at(1.9)), Act::nothing);
  EXPECT_EQ(up.process.next(at(1.901)), Act::kill);
  EXPECT_EQ(up.process.next(at(5.0)), Act::nothing);
  up.process.ended(kKilled, "", at(5.0));
  EXPECT_EQ(up.process.last_end(), "was killed by signal 9 (Killed): no sign of life for 0.9 s");
}

TEST(SupervisedProcess, OneThatSaysThatItHangsIsKilledAtOnce) {
  Up up;
  up.process.heard(said("WATCHDOG=trigger\nSTATUS=lane local has not come back for 0.70 s"), at(0.4));
  EXPECT_EQ(up.process.next(at(0.4)), Act::kill);
  EXPECT_EQ(up.process.fault(), "lane local has not come back for 0.70 s");
}

TEST(SupervisedProcess, OneThatNeverSaysReadyIsKilledAfterAMinute) {
  SupervisedProcess process;
  process.started(at(0.0));
  process.heard(said("WATCHDOG=1\nSTATUS=looks for its device"), at(59.0));
  EXPECT_EQ(process.next(at(60.0)), Act::nothing);
  EXPECT_EQ(process.next(at(60.1)), Act::kill);
  EXPECT_EQ(process.fault(), "did not say READY=1 within 60 s");
}

// Its first line tells how the one before it ended; killed before it says anything else, that line is the last, and
// a process that is killed again and again would have a longer one each time.
TEST(SupervisedProcess, TheLastWordsOfTheOneBeforeAreNotItsOwn) {
  Up up;
  up.process.ended(kKilled, "no more memory", at(9.0));
  up.process.started(at(9.0));
  up.process.ended(kKilled, "started again; the process before it " + up.process.last_end(), at(10.0));
  EXPECT_EQ(up.process.last_end(),
            "was killed by signal 9 (Killed); last words: started again; the process before it was killed by "
            "signal 9 (Killed)");
}

TEST(SupervisedProcess, OneThatIsKilledIsStartedAtOnceAndKeepsWhatBecameOfTheOneBefore) {
  Up up;
  up.process.ended(kKilled, "no more memory", at(9.0));
  EXPECT_EQ(up.process.next(at(9.0)), Act::start);
  up.process.started(at(9.0));
  EXPECT_EQ(up.process.last_end(), "was killed by signal 9 (Killed); last words: no more memory");
  EXPECT_EQ(up.process.starts(), 2);
  EXPECT_EQ(up.process.time_to_ready(), std::nullopt);
}

// Five restarts within a minute: at once, after .2, .4, .8 and 1.6 s; the sixth failure is the end.
TEST(SupervisedProcess, ACrashLoopIsSlowedAndGivenUp) {
  SupervisedProcess process;
  std::vector<double> pauses;
  Duration now;
  while (process.given_up().empty()) {
    process.started(now);
    process.ended(1, "no such device", now);
    const Duration since = now;
    while (process.given_up().empty() && process.next(now) != Act::start)
      now = now + Duration::milliseconds(100);
    pauses.push_back((now - since).to_seconds());
  }
  EXPECT_THAT(pauses, testing::ElementsAre(0.0, 0.2, 0.4, 0.8, 1.6, 0.0));
  EXPECT_EQ(process.starts(), 6);
  EXPECT_TRUE(process.is_done());
  EXPECT_EQ(process.given_up(),
            "started again 5 times within 60 s, and ended with status 1; last words: no such device");
}

TEST(SupervisedProcess, FailuresThatAreFarApartAreBorneForEver) {
  SupervisedProcess process;
  for (int i = 0; i < 100; ++i) {
    process.started(at(13.0 * i));
    process.ended(kKilled, "", at(13.0 * i + 1.0));
    EXPECT_EQ(process.given_up(), "") << i;
  }
}

TEST(SupervisedProcess, AWrongConfigurationIsNotTriedTwice) {
  SupervisedProcess process;
  process.started(at(0.0));
  process.ended(2, "hallway.yaml:3: unknown key", at(0.1));
  EXPECT_TRUE(process.is_done());
  EXPECT_THAT(process.given_up(), HasSubstr("unknown key"));
}

TEST(SupervisedProcess, WhatIsOverByItsOwnDecisionIsNotStartedAgain) {
  Up up;
  up.process.heard(said("STOPPING=1\nX_BANDWAGON_OVER=1\nSTATUS=goal reached"), at(20.0));
  EXPECT_EQ(up.process.next(at(34.9)), Act::nothing);  // at rest first, without a sign of life
  up.process.ended(0, "", at(35.0));
  EXPECT_TRUE(up.process.is_done());
  EXPECT_EQ(up.process.given_up(), "");
}

TEST(SupervisedProcess, WhatStopsBecauseItFailedIsStartedAgain) {
  Up up;
  up.process.heard(said("STOPPING=1\nSTATUS=planner failed in tick: out of range"), at(20.0));
  up.process.ended(1, "", at(21.0));
  EXPECT_EQ(up.process.next(at(21.0)), Act::start);
}

TEST(SupervisedProcess, IsAskedToEndOnceAndKilledWhenItDoesNot) {
  Up up;
  up.process.ask_to_end(false);
  EXPECT_EQ(up.process.next(at(1.0)), Act::terminate);
  EXPECT_EQ(up.process.next(at(2.0)), Act::nothing);
  EXPECT_EQ(up.process.next(at(16.1)), Act::kill);
  up.process.ended(kKilled, "", at(16.2));
  EXPECT_TRUE(up.process.is_done());
}

// As a process does that had no time yet for handlers of its own.
TEST(SupervisedProcess, ToEndBySigtermIsToObeyOnlyWhereItWasAsked) {
  Up asked;
  asked.process.ask_to_end(false);
  EXPECT_EQ(asked.process.next(at(0.4)), Act::terminate);
  asked.process.ended(128 + 15, "", at(0.4));
  EXPECT_EQ(asked.process.last_status(), 0);
  Up other;
  other.process.ended(128 + 15, "", at(0.4));
  EXPECT_EQ(other.process.last_status(), 128 + 15);
}

TEST(SupervisedProcess, ARestartThatWasAskedForCountsNothing) {
  Up up;
  for (int i = 0; i < 20; ++i) {
    up.process.ask_to_end(true);
    EXPECT_EQ(up.process.next(at(0.3 + 0.1 * i)), Act::terminate);
    up.process.ended(0, "", at(0.3 + 0.1 * i));
    EXPECT_EQ(up.process.next(at(0.3 + 0.1 * i)), Act::start);
    up.process.started(at(0.3 + 0.1 * i));
    up.process.heard(said("READY=1"), at(0.3 + 0.1 * i));
  }
  EXPECT_EQ(up.process.state(), State::up);
}

TEST(SupervisedProcess, OneThatWaitsForItsRestartEndsWithTheOthers) {
  Up up;
  up.process.ended(kKilled, "", at(1.0));
  up.process.ask_to_end(false);
  EXPECT_TRUE(up.process.is_done());
}

}  // namespace
}  // namespace bw
