// Ids and labels are those of lifecycle_msgs; which transitions a state has, and how they end, is ROS 2's
// picture of a managed node.
#include "runtime/lifecycle/state_machine.hpp"

#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bw::lifecycle {
namespace {

using testing::ElementsAre;

/// "configure [1] unconfigured>configuring"
std::string text(const Transition& t) {
  return std::string(t.label) + " [" + std::to_string(t.id) + "] " + std::string(label(t.start)) + ">" +
         std::string(label(t.goal));
}

std::vector<std::string> texts_from(State state) {
  std::vector<std::string> texts;
  for (const Transition& t : transitions_from(state)) texts.push_back(text(t));
  return texts;
}

TEST(StateMachine, HasTheElevenStatesOfRos) {
  std::vector<std::string> all;
  for (const State state : states())
    all.push_back(std::to_string(static_cast<int>(state)) + " " + std::string(label(state)));
  EXPECT_THAT(all, ElementsAre("0 unknown", "1 unconfigured", "2 inactive", "3 active", "4 finalized",
                               "10 configuring", "11 cleaningup", "12 shuttingdown", "13 activating",
                               "14 deactivating", "15 errorprocessing"));
}

TEST(StateMachine, WhatMayBeAskedForInEachPrimaryState) {
  EXPECT_THAT(texts_from(State::unconfigured), ElementsAre("configure [1] unconfigured>configuring",
                                                           "shutdown [5] unconfigured>shuttingdown"));
  EXPECT_THAT(texts_from(State::inactive),
              ElementsAre("cleanup [2] inactive>cleaningup", "activate [3] inactive>activating",
                          "shutdown [6] inactive>shuttingdown"));
  EXPECT_THAT(texts_from(State::active),
              ElementsAre("deactivate [4] active>deactivating", "shutdown [7] active>shuttingdown"));
  EXPECT_THAT(texts_from(State::finalized), ElementsAre());
  EXPECT_THAT(texts_from(State::unknown), ElementsAre());
}

TEST(StateMachine, EveryTransitionalStateEndsInThreeWays) {
  // 7 that may be asked for and 3 endings of each of the 6 transitional states: 25.
  EXPECT_EQ(transitions().size(), 25U);
  const auto goals = [](State state) {
    std::vector<State> ends;
    for (const Outcome outcome : {Outcome::success, Outcome::failure, Outcome::error})
      ends.push_back(finishing_transition(state, outcome).goal);
    return ends;
  };
  using enum State;
  EXPECT_THAT(goals(configuring), ElementsAre(inactive, unconfigured, errorprocessing));
  EXPECT_THAT(goals(cleaningup), ElementsAre(unconfigured, inactive, errorprocessing));
  EXPECT_THAT(goals(activating), ElementsAre(active, inactive, errorprocessing));
  EXPECT_THAT(goals(deactivating), ElementsAre(inactive, active, errorprocessing));
  EXPECT_THAT(goals(shuttingdown), ElementsAre(finalized, finalized, errorprocessing));
  EXPECT_THAT(goals(errorprocessing), ElementsAre(unconfigured, finalized, finalized));
  EXPECT_EQ(finishing_transition(deactivating, Outcome::error).id, 42);
  EXPECT_THROW((void)finishing_transition(active, Outcome::success), std::logic_error);
}

TEST(StateMachine, ALabelWinsOverTheId) {
  const Transition* found = requested_transition(State::inactive, transition_id::kConfigure, "activate");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->id, transition_id::kActivate);
  EXPECT_EQ(requested_transition(State::inactive, transition_id::kActivate, "go"), nullptr)
      << "an unknown label";
  EXPECT_EQ(requested_transition(State::inactive, transition_id::kActivate, "configure"), nullptr)
      << "not from here";
  EXPECT_EQ(requested_transition(State::active, 0, "shutdown")->id, transition_id::kActiveShutdown);
}

TEST(StateMachine, WithoutALabelTheIdDecidesAndBelongsToTheState) {
  EXPECT_EQ(requested_transition(State::inactive, transition_id::kActivate, "")->goal, State::activating);
  EXPECT_EQ(requested_transition(State::active, transition_id::kActivate, ""), nullptr);
  EXPECT_EQ(requested_transition(State::inactive, transition_id::kUnconfiguredShutdown, ""), nullptr);
  EXPECT_EQ(requested_transition(State::unconfigured, 0, ""), nullptr);
  EXPECT_EQ(requested_transition(State::unconfigured, 255, ""), nullptr);
  EXPECT_EQ(requested_transition(State::configuring, 10, ""), nullptr)
      << "the node alone finishes a transition";
  EXPECT_EQ(requested_transition(State::configuring, 0, "transition_success"), nullptr);
}

}  // namespace
}  // namespace bw::lifecycle
