// Steps by hand from the table in bring_up.hpp; nodes are a, b, c in the order of bring-up.
#include "runtime/lifecycle/bring_up.hpp"

#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bw::lifecycle {
namespace {

using testing::ElementsAre;
using enum State;

struct Walk {
  std::vector<std::string> steps;
  std::vector<State> nodes;
  std::string failure;  ///< "activate b", "" when all went well
};

/// Steps in `broken` leave the node where it was, a deactivation of them `unconfigured`.
Walk walk(Command command, std::vector<State> nodes, const std::set<std::string>& broken = {}) {
  Walk result;
  const auto name = [](const BringUp::Step& step) {
    return std::string(step.transition) + " " + std::string(1, static_cast<char>('a' + step.node));
  };
  BringUp bring_up(command, std::move(nodes));
  while (const auto step = bring_up.next()) {
    result.steps.push_back(name(*step));
    const bool fails = broken.contains(result.steps.back());
    bring_up.finished(!fails ? step->goal : step->transition == "deactivate" ? unconfigured : step->from);
  }
  result.nodes = bring_up.nodes();
  if (bring_up.failure()) result.failure = name(*bring_up.failure());
  return result;
}

TEST(BringUp, StartupConfiguresAllThenActivatesAll) {
  const Walk up = walk(Command::startup, {unconfigured, unconfigured, unconfigured});
  EXPECT_THAT(up.steps, ElementsAre("configure a", "configure b", "configure c", "activate a", "activate b",
                                    "activate c"));
  EXPECT_THAT(up.nodes, ElementsAre(active, active, active));
  EXPECT_EQ(up.failure, "");
}

TEST(BringUp, TheWayDownIsBackwards) {
  EXPECT_THAT(walk(Command::pause, {active, active}).steps, ElementsAre("deactivate b", "deactivate a"));
  EXPECT_THAT(walk(Command::reset, {active, active}).steps,
              ElementsAre("deactivate b", "deactivate a", "cleanup b", "cleanup a"));
  const Walk down = walk(Command::shutdown, {active, unconfigured});
  EXPECT_THAT(down.steps, ElementsAre("deactivate a", "cleanup a", "shutdown b", "shutdown a"));
  EXPECT_THAT(down.nodes, ElementsAre(finalized, finalized));
  EXPECT_EQ(down.failure, "");
}

TEST(BringUp, HalvesOfTheWayUp) {
  EXPECT_THAT(walk(Command::configure, {unconfigured, unconfigured}).steps,
              ElementsAre("configure a", "configure b"));
  EXPECT_THAT(walk(Command::resume, {inactive, inactive}).steps, ElementsAre("activate a", "activate b"));
  EXPECT_THAT(walk(Command::cleanup, {inactive, inactive}).steps, ElementsAre("cleanup b", "cleanup a"));
}

TEST(BringUp, WhatIsThereAlreadyIsPassedOver) {
  EXPECT_THAT(walk(Command::startup, {active, inactive, unconfigured}).steps,
              ElementsAre("configure c", "activate b", "activate c"));
  const Walk again = walk(Command::startup, {active, active});
  EXPECT_THAT(again.steps, ElementsAre());
  EXPECT_EQ(again.failure, "");
}

TEST(BringUp, AFailureOnTheWayUpBringsEverythingToRest) {
  const Walk up = walk(Command::startup, {unconfigured, unconfigured, unconfigured}, {"activate b"});
  EXPECT_THAT(up.steps, ElementsAre("configure a", "configure b", "configure c", "activate a", "activate b",
                                    "deactivate a"));
  EXPECT_THAT(up.nodes, ElementsAre(inactive, inactive, inactive));
  EXPECT_EQ(up.failure, "activate b");

  const Walk early = walk(Command::startup, {active, unconfigured, unconfigured}, {"configure b"});
  EXPECT_THAT(early.steps, ElementsAre("configure b", "deactivate a"));
  EXPECT_EQ(early.failure, "configure b");

  EXPECT_THAT(walk(Command::configure, {unconfigured, unconfigured}, {"configure a"}).steps,
              ElementsAre("configure a"));
}

TEST(BringUp, AFailureOnTheWayDownStopsNobodyElse) {
  const Walk down = walk(Command::pause, {active, active, active}, {"deactivate b"});
  EXPECT_THAT(down.steps, ElementsAre("deactivate c", "deactivate b", "deactivate a"));
  EXPECT_THAT(down.nodes, ElementsAre(inactive, unconfigured, inactive));
  EXPECT_EQ(down.failure, "deactivate b");
}

TEST(BringUp, WhatCannotBeAskedForFailsWithoutAStep) {
  const Walk resume = walk(Command::resume, {inactive, unconfigured});
  EXPECT_THAT(resume.steps, ElementsAre("activate a", "deactivate a"));
  EXPECT_EQ(resume.failure, "activate b");
  EXPECT_EQ(walk(Command::cleanup, {active}).failure, "cleanup a");
  EXPECT_EQ(walk(Command::startup, {finalized}).failure, "configure a");
  EXPECT_EQ(walk(Command::shutdown, {finalized}).failure, "");
}

TEST(BringUp, CommandsAreNumberedAsInNav2) {
  EXPECT_EQ(command_of(0), Command::startup);
  EXPECT_EQ(command_of(6), Command::cleanup);
  EXPECT_EQ(command_of(7), std::nullopt);
}

}  // namespace
}  // namespace bw::lifecycle
