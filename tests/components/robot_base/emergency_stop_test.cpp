// Who presses, who lifts, who leaves, who falls silent: all of it against the rule that only a release lets
// go, and none while a button is down that is still there.
#include "components/robot_base/emergency_stop.hpp"

#include <set>

#include <gmock/gmock.h>

namespace bw {
namespace {

using testing::HasSubstr;
using Writer = EmergencyStop::Writer;

Time at(double seconds) { return Time::seconds(1000.0 + seconds); }
Writer writer(int i) { return {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i >> 8)}; }
const Writer kA = writer(1), kB = writer(2);
std::optional<Duration> everybody(const Writer&) { return Duration{}; }
std::optional<Duration> nobody(const Writer&) { return std::nullopt; }

TEST(EmergencyStop, AFalseFirstLatchesNothing) {
  EmergencyStop stop;
  stop.hear(at(0.0), kA, "/a", false);
  EXPECT_FALSE(stop.is_latched());
  EXPECT_EQ(stop.reason(), "");
  EXPECT_EQ(stop.refusal(everybody), std::nullopt);
}

TEST(EmergencyStop, AFalseLiftsOnesOwnButtonAndNoOther) {
  EmergencyStop stop;
  stop.hear(at(0.0), kA, "/a", true);
  stop.hear(at(0.1), kB, "/b", true);
  EXPECT_EQ(stop.reason(), "the emergency stop is pressed by /a, /b");
  stop.hear(at(0.2), kA, "/a", false);
  EXPECT_EQ(stop.refusal(everybody), "the emergency stop is pressed by /b");
  stop.hear(at(0.3), kA, "/a", false);
  EXPECT_EQ(stop.refusal(everybody), "the emergency stop is pressed by /b");
  stop.hear(at(0.4), kB, "/b", false);
  EXPECT_EQ(stop.refusal(everybody), std::nullopt);
  EXPECT_TRUE(stop.is_latched());  // still: nobody has released it
  EXPECT_EQ(stop.reason(), "the emergency stop was pressed by /b");
  EXPECT_EQ(stop.release(), "");
  EXPECT_FALSE(stop.is_latched());
}

TEST(EmergencyStop, WhoHasLeftDoesNotRefuseAndIsNamed) {
  EmergencyStop stop;
  stop.hear(at(0.0), kA, "/a", true);
  stop.hear(at(0.1), kB, "/b", true);
  EXPECT_EQ(stop.refusal([](const Writer& w) { return w == kB ? std::optional(Duration{}) : std::nullopt; }),
            "the emergency stop is pressed by /b");
  stop.hear(at(0.2), kB, "/b", false);
  EXPECT_EQ(stop.refusal(nobody), std::nullopt);
  EXPECT_EQ(stop.release(), "/a pressed the emergency stop and has left");
  EXPECT_FALSE(stop.is_latched());
}

TEST(EmergencyStop, AThousandWhoPressAreAsManyButtons) {
  EmergencyStop stop;
  for (int i = 0; i < 1000; ++i) stop.hear(at(0.001 * i), writer(i), "/n" + std::to_string(i), true);
  for (int i = 0; i < 1000; ++i) stop.hear(at(1.0 + 0.001 * i), writer(i), "/n" + std::to_string(i), true);
  EXPECT_EQ(stop.record().pressed.size(), 1000U);
  EXPECT_EQ(*stop.refusal(everybody),
            "the emergency stop is pressed by /n0, /n1, /n2, /n3, /n4 and 995 more");
  for (int i = 0; i < 999; ++i) stop.hear(at(2.0), writer(i), "", false);
  EXPECT_EQ(*stop.refusal(everybody), "the emergency stop is pressed by /n999");
  stop.hear(at(3.0), writer(999), "", false);
  EXPECT_EQ(stop.refusal(everybody), std::nullopt);
}

// A killed process has said nothing: for its lease it counts as there, which who asks for a release has to
// know. Of several the longest counts; 1.5 s is told as 2, and a lease without an end as one.
TEST(EmergencyStop, ARefusalSaysForHowLongWhoWasKilledCountsAsThere) {
  EmergencyStop stop;
  stop.hear(at(0.0), kA, "/a", true);
  const auto leases = [](Duration of_a, Duration of_b) {
    return [=](const Writer& w) { return std::optional(w == kA ? of_a : of_b); };
  };
  EXPECT_EQ(stop.refusal(leases(Duration::seconds(1.5), {})),
            "the emergency stop is pressed by /a; one that was killed counts as there for 2 s after that");
  stop.hear(at(0.0), kB, "/b", true);
  EXPECT_EQ(
      stop.refusal(leases(Duration::seconds(4.0), Duration::seconds(20.0))),
      "the emergency stop is pressed by /a, /b; one that was killed counts as there for 20 s after that");
  const Duration no_end{std::numeric_limits<std::int64_t>::max()};
  EXPECT_EQ(
      stop.refusal(leases(Duration::seconds(4.0), no_end)),
      "the emergency stop is pressed by /a, /b; one that was killed counts as there until this base is started anew");
}

TEST(EmergencyStop, ANameThatComesLateIsToldOfLater) {
  EmergencyStop stop;
  stop.hear(at(0.0), kA, "", true);
  EXPECT_EQ(stop.reason(), "the emergency stop is pressed by somebody without a node name");
  stop.name([](const Writer&) { return std::string("/a"); });
  EXPECT_EQ(stop.reason(), "the emergency stop is pressed by /a");
  stop.hear(at(0.1), kA, "/a", false);
  EXPECT_EQ(stop.reason(), "the emergency stop was pressed by /a");
}

TEST(EmergencyStop, ARecordLatchesAnotherAsThisOneWas) {
  EmergencyStop before;
  before.hear(at(0.0), kA, "/a", true);
  EmergencyStop after;
  after.restore(before.record());
  EXPECT_TRUE(after.is_latched());
  EXPECT_EQ(after.refusal(everybody), "the emergency stop is pressed by /a");
  after.hear(at(5.0), kA, "/a", false);
  EXPECT_EQ(after.refusal(everybody), std::nullopt);
}

EmergencyStopOptions panel() { return {.buttons = {{.node = "/panel", .heartbeat = 0.5}}}; }

TEST(EmergencyStop, AListedButtonThatFallsSilentIsAStopUntilItIsHeardAndReleased) {
  EmergencyStop stop;
  stop.begin(at(0.0), panel());
  stop.step(at(0.5));
  EXPECT_FALSE(stop.is_latched());
  stop.hear(at(0.5), kA, "/panel", false);
  stop.hear(at(0.9), kB, "/somebody_else", false);
  stop.step(at(1.0));
  EXPECT_FALSE(stop.is_latched());
  stop.step(at(1.001));
  EXPECT_EQ(stop.reason(), "the emergency stop button /panel is silent");
  EXPECT_EQ(stop.refusal(nobody), "the emergency stop button /panel is silent");
  stop.hear(at(2.0), kA, "/panel", false);
  stop.step(at(2.01));
  EXPECT_TRUE(stop.is_latched());
  EXPECT_EQ(stop.refusal(everybody), std::nullopt);
}

TEST(EmergencyStop, AListedButtonThatIsNeverHeardIsAStop) {
  EmergencyStop stop;
  stop.begin(at(0.0), panel());
  stop.step(at(0.51));
  EXPECT_TRUE(stop.is_latched());
}

// An hour back: what was heard "in an hour" does not count for as long.
TEST(EmergencyStop, AClockThatGoesBackLeavesNoHeartbeatFresh) {
  EmergencyStop stop;
  stop.begin(at(3600.0), panel());
  stop.hear(at(3600.0), kA, "/panel", false);
  stop.step(at(0.0));
  EXPECT_FALSE(stop.is_latched());
  stop.step(at(0.51));
  EXPECT_TRUE(stop.is_latched());
}

TEST(EmergencyStopOptions, ButtonsAreFullNamesAndDiffer) {
  EXPECT_EQ(panel().violated_rule(), std::nullopt);
  EmergencyStopOptions options;
  options.buttons = {{.node = "panel"}};
  EXPECT_THAT(*options.violated_rule(), HasSubstr("full names"));
  options.buttons = {{}, {}};
  EXPECT_THAT(*options.violated_rule(), HasSubstr("twice"));
}

// Every sequence of these events up to six: press and lift of two buttons, one that leaves, a release that is
// asked for. Against a model of sets: latched from a press until a release, which is refused while a button
// is down that is there.
TEST(EmergencyStop, EverySequenceOfSixEventsKeepsTheRule) {
  constexpr int kEvents = 6, kDepth = 6;
  int sequences = 0;
  for (int code = 0; code < 46656; ++code) {  // 6^6
    EmergencyStop stop;
    std::set<int> down;
    bool is_latched = false, has_left = false;
    for (int i = 0, rest = code; i < kDepth; ++i, rest /= kEvents) {
      const int event = rest % kEvents;
      const Time now = at(0.01 * i);
      const auto lease_of = [&](const Writer& w) {
        return has_left && w == kA ? std::nullopt : std::optional(Duration{});
      };
      if (event <= 1 && !(event == 0 && has_left)) {
        stop.hear(now, event == 0 ? kA : kB, event == 0 ? "/a" : "/b", true);
        down.insert(event);
        is_latched = true;
      } else if ((event == 2 && !has_left) || event == 3) {
        stop.hear(now, event == 2 ? kA : kB, "", false);
        down.erase(event - 2);
      } else if (event == 4) {
        has_left = true;
      } else if (event == 5) {
        const bool is_refused = down.contains(1) || (down.contains(0) && !has_left);
        ASSERT_EQ(stop.refusal(lease_of).has_value(), is_refused) << code;
        if (!is_refused) {
          const std::string said = stop.release();
          ASSERT_EQ(said.empty(), !down.contains(0)) << code << said;
          down.clear();
          is_latched = false;
        }
      }
      ASSERT_EQ(stop.is_latched(), is_latched) << code;
      ASSERT_EQ(stop.reason().empty(), !is_latched) << code;
    }
    ++sequences;
  }
  EXPECT_EQ(sequences, 46656);
}

}  // namespace
}  // namespace bw
