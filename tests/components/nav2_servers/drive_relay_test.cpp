#include "components/nav2_servers/drive_relay.hpp"

#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const Time kNow = Time::seconds(100.0);
constexpr ServersReady kAll{.follow_path = true, .back_up = true};

/// Sends what is due and returns its number.
std::uint64_t sent(DriveRelay& relay) {
  const RelayActions actions = relay.step(kAll, kNow);
  EXPECT_TRUE(actions.send);
  return actions.send ? actions.send->number : 0;
}

ServerEnd end(GoalStatus status, std::uint16_t code = 0, const std::string& text = "") {
  return {status, code, text};
}

TEST(DriveRelay, APathIsFollowedUntilTheServerSaysReached) {
  DriveRelay relay;
  EXPECT_EQ(relay.report().state, FollowState::idle);
  relay.order(7, FollowMode::follow);
  const std::uint64_t number = sent(relay);
  relay.acknowledged(number, true);
  EXPECT_EQ(relay.report().id, 7U);
  EXPECT_EQ(relay.report().state, FollowState::following);
  EXPECT_FALSE(relay.step(kAll, kNow).send) << "it was sent";
  relay.ended(number, end(GoalStatus::succeeded));
  EXPECT_EQ(relay.report().state, FollowState::reached);
}

// The server ends the old goal itself; its end says nothing of the new one.
TEST(DriveRelay, ANewerPathIsSentAtOnceAndNothingIsCanceled) {
  DriveRelay relay;
  relay.order(1, FollowMode::follow);
  const std::uint64_t first = sent(relay);
  relay.acknowledged(first, true);
  relay.order(2, FollowMode::follow);
  const RelayActions actions = relay.step(kAll, kNow);
  ASSERT_TRUE(actions.send);
  EXPECT_THAT(actions.cancel, IsEmpty());
  relay.ended(first, end(GoalStatus::aborted));
  EXPECT_EQ(relay.report().state, FollowState::following);
  EXPECT_FALSE(relay.step(kAll, kNow).clear_costmap);
}

TEST(DriveRelay, AStopCancelsWhatWasAcknowledgedAndTheRestOnceItIs) {
  DriveRelay relay;
  relay.order(1, FollowMode::follow);
  const std::uint64_t first = sent(relay);
  relay.acknowledged(first, true);
  relay.order(2, FollowMode::follow);
  const std::uint64_t second = sent(relay);
  relay.order(3, FollowMode::stop);
  EXPECT_EQ(relay.report().state, FollowState::idle);
  EXPECT_THAT(relay.step(kAll, kNow).cancel, ElementsAre(first));
  relay.acknowledged(second, true);
  EXPECT_THAT(relay.step(kAll, kNow).cancel, ElementsAre(second));
  relay.ended(first, end(GoalStatus::canceled));
  EXPECT_THAT(relay.step(kAll, kNow + Duration::milliseconds(990)).cancel, IsEmpty());
  EXPECT_THAT(relay.step(kAll, kNow + Duration::milliseconds(1000)).cancel, ElementsAre(second))
      << "it drives on: the server may not have heard";
  relay.ended(second, end(GoalStatus::canceled));
  EXPECT_THAT(relay.step(kAll, kNow + Duration::milliseconds(5000)).cancel, IsEmpty());
}

TEST(DriveRelay, ItDrivesBackOnlyWhenTheControllerHasEnded) {
  DriveRelay relay;
  relay.order(1, FollowMode::follow);
  const std::uint64_t path = sent(relay);
  relay.acknowledged(path, true);
  relay.order(2, FollowMode::back_off);
  RelayActions actions = relay.step(kAll, kNow);
  EXPECT_THAT(actions.cancel, ElementsAre(path));
  EXPECT_FALSE(actions.send);
  relay.ended(path, end(GoalStatus::canceled));
  actions = relay.step(kAll, kNow);
  ASSERT_TRUE(actions.send);
  EXPECT_EQ(actions.send->mode, FollowMode::back_off);
  relay.acknowledged(actions.send->number, true);
  relay.order(3, FollowMode::follow);
  EXPECT_THAT(relay.step(kAll, kNow).cancel, ElementsAre(actions.send->number));
}

TEST(DriveRelay, SaysWhyItFailed) {
  struct Case {
    ServerEnd how;
    std::string reason;
    bool clears;
  };
  const Case cases[] = {
      {end(GoalStatus::aborted, 105, "no progress"), "controller_server: no progress", true},
      {end(GoalStatus::aborted, 105), "controller_server gave up with error code 105", true},
      {end(GoalStatus::aborted), "controller_server gave up", true},
      {end(GoalStatus::canceled), "controller_server was canceled by somebody else", false},
      {end(GoalStatus::unknown), "controller_server is gone", false}};
  for (const Case& c : cases) {
    DriveRelay relay;
    relay.order(1, FollowMode::follow);
    const std::uint64_t number = sent(relay);
    relay.acknowledged(number, true);
    relay.ended(number, c.how);
    EXPECT_EQ(relay.report().state, FollowState::failed);
    EXPECT_EQ(relay.report().reason, c.reason);
    EXPECT_EQ(relay.report().error_code, c.how.error_code);
    EXPECT_EQ(relay.step(kAll, kNow).clear_costmap, c.clears);
    EXPECT_FALSE(relay.step(kAll, kNow).send) << "what failed is not tried again unasked";
  }
}

// The controller gives up each path within 0.1 s, and each is renewed: it has failed all the time, until one
// lasts for 0.5 s.
TEST(DriveRelay, APathAfterAFailedOneIsDoubtedUntilItLasts) {
  DriveRelay relay;
  relay.order(1, FollowMode::follow);
  relay.ended(sent(relay), end(GoalStatus::aborted, 106, "no way"));
  relay.order(2, FollowMode::follow);
  const std::uint64_t second = sent(relay);
  EXPECT_EQ(relay.report().id, 2U);
  EXPECT_EQ(relay.report().state, FollowState::failed);
  EXPECT_EQ(relay.report().error_code, 106);
  relay.step(kAll, kNow + Duration::milliseconds(490));
  EXPECT_EQ(relay.report().state, FollowState::failed);
  relay.step(kAll, kNow + Duration::milliseconds(500));
  EXPECT_EQ(relay.report().state, FollowState::following);
  EXPECT_EQ(relay.report().error_code, 0);
  relay.ended(second, end(GoalStatus::aborted, 106));
  relay.order(3, FollowMode::stop);
  relay.order(4, FollowMode::follow);
  EXPECT_EQ(relay.report().state, FollowState::following) << "after a rest it begins anew";
}

TEST(DriveRelay, AServerThatIsNotThereOrSaysNoIsAFailure) {
  DriveRelay relay;
  relay.order(1, FollowMode::follow);
  EXPECT_FALSE(relay.step({}, kNow).send);
  EXPECT_EQ(relay.report().state, FollowState::failed);
  EXPECT_EQ(relay.report().reason, "there is no controller_server");
  relay.order(2, FollowMode::back_off);
  EXPECT_FALSE(relay.step({.follow_path = true}, kNow).send);
  EXPECT_EQ(relay.report().reason, "there is no behavior_server");
  relay.order(3, FollowMode::follow);
  relay.acknowledged(sent(relay), false);
  EXPECT_EQ(relay.report().reason, "controller_server does not take the goal");
}

TEST(DriveRelay, CodesOfBothPlanningActionsMeanTheSame) {
  for (const int base : {200, 300}) {
    const auto outcome = [base](int offset) { return outcome_of(static_cast<std::uint16_t>(base + offset)); };
    EXPECT_EQ(outcome(1), PlanOutcome::bad_request);
    EXPECT_EQ(outcome(3), PlanOutcome::start_blocked);
    EXPECT_EQ(outcome(4), PlanOutcome::goal_blocked);
    EXPECT_EQ(outcome(5), PlanOutcome::start_blocked);
    EXPECT_EQ(outcome(6), PlanOutcome::goal_blocked);
    EXPECT_EQ(outcome(8), PlanOutcome::disconnected);
    for (const int other : {0, 2, 7}) EXPECT_EQ(outcome(other), PlanOutcome::failed);
  }
  EXPECT_EQ(outcome_of(0), PlanOutcome::failed) << "Humble tells no code";
}

// Whatever is ordered and however servers answer: never two servers at once, and after a stop nothing runs.
TEST(DriveRelay, OneServerDrivesAtATime) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    DriveRelay relay;
    std::map<std::uint64_t, FollowMode> running;  // as the servers see it
    std::map<std::uint64_t, bool> canceled;
    const auto step = [&] {
      const RelayActions actions = relay.step(kAll, kNow);
      for (const std::uint64_t number : actions.cancel) canceled[number] = true;
      if (!actions.send) return;
      for (const auto& [number, mode] : running) ASSERT_EQ(mode, actions.send->mode) << "seed " << seed;
      running[actions.send->number] = actions.send->mode;
    };
    for (std::uint64_t event = 1; event <= 100; ++event) {
      const double dice = random.uniform();
      if (dice < 0.4) {
        relay.order(event, static_cast<FollowMode>(static_cast<int>(random.uniform(0.0, 3.0))));
      } else if (!running.empty()) {
        const std::uint64_t number = running.begin()->first;
        if (dice < 0.6) {
          relay.acknowledged(number, true);
        } else if (dice < 0.7) {
          relay.acknowledged(number, false);
          running.erase(number);
        } else {
          relay.ended(number, end(GoalStatus::aborted));
          running.erase(number);
        }
      }
      step();
    }
    relay.order(1000, FollowMode::stop);
    for (const auto& [number, mode] : running) relay.acknowledged(number, true);
    step();
    for (const auto& [number, mode] : running) EXPECT_TRUE(canceled[number]) << "seed " << seed;
  }
}

}  // namespace
}  // namespace bw
