// The nodes of the tree against what BehaviorTree.CPP 4 and nav2_behavior_tree document of them.
#include "tests/interop/nav2_tree/tree_nodes.hpp"

#include <deque>

#include <gmock/gmock.h>

#include "tests/interop/nav2_tree/commands.hpp"

namespace nav2 {
namespace {

using testing::ElementsAre;
using enum Status;

/// Says what it is told to say, once each, and notes what is done to it.
class Scripted final : public TreeNode {
 public:
  Scripted(std::string name, std::deque<Status> script, std::vector<std::string>& log)
      : name_(std::move(name)), script_(std::move(script)), log_(log) {}

 private:
  Status on_tick() override {
    log_.push_back(name_);
    const Status status = script_.front();
    if (script_.size() > 1) script_.pop_front();
    return status;
  }
  void on_halt() override { log_.push_back("halt " + name_); }
  std::string name_;
  std::deque<Status> script_;
  std::vector<std::string>& log_;
};

class Tree : public testing::Test {
 protected:
  NodePtr node(const std::string& name, std::deque<Status> script) {
    return std::make_unique<Scripted>(name, std::move(script), log_);
  }
  std::vector<std::string> log_;
};

TEST_F(Tree, ASequenceKeepsItsPlace) {
  Sequence sequence(children(node("a", {success}), node("b", {running, success})));
  EXPECT_EQ(sequence.tick(), running);
  EXPECT_EQ(sequence.tick(), success);
  EXPECT_THAT(log_, ElementsAre("a", "b", "b"));
}

TEST_F(Tree, APipelineTicksThoseBeforeAgainAndHaltsAllWithTheFirstFailure) {
  PipelineSequence pipeline(
      children(node("plan", {success, running, success, failure}), node("follow", {running})));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(pipeline.tick(), running);
  EXPECT_EQ(pipeline.tick(), failure);
  EXPECT_THAT(log_, ElementsAre("plan", "follow", "plan", "follow", "plan", "follow", "plan", "halt follow"));
}

TEST_F(Tree, ARecoveryIsTriedAsOftenAsItSays) {
  RecoveryNode recovery(2, children(node("work", {failure}), node("recover", {success})));
  EXPECT_EQ(recovery.tick(), failure);
  EXPECT_THAT(log_, ElementsAre("work", "recover", "work", "recover", "work"));
}

TEST_F(Tree, ARecoveryThatFailsEndsIt) {
  RecoveryNode recovery(2, children(node("work", {failure}), node("recover", {failure})));
  EXPECT_EQ(recovery.tick(), failure);
  EXPECT_THAT(log_, ElementsAre("work", "recover"));
}

TEST_F(Tree, ARoundRobinGoesOnWhereItWasAndSkipsWhatFails) {
  RoundRobin robin(children(node("clear", {success}), node("spin", {failure}), node("wait", {success})));
  EXPECT_EQ(robin.tick(), success);
  robin.halt();  // by its parent, when it has succeeded: only what runs is interrupted
  EXPECT_EQ(robin.tick(), success);
  robin.halt();
  EXPECT_EQ(robin.tick(), success);
  EXPECT_THAT(log_, ElementsAre("clear", "spin", "wait", "clear"));
}

TEST_F(Tree, ARateControllerTicksAtOnceAndThenRests) {
  RateController rate(std::chrono::hours(1), node("plan", {running, success}));
  EXPECT_EQ(rate.tick(), running);
  EXPECT_EQ(rate.tick(), success);
  EXPECT_EQ(rate.tick(), running) << "in between";
  EXPECT_THAT(log_, ElementsAre("plan", "plan"));
}

// 10 Hz; the line from 0.5 m/s at 1.0 s to 0.5 m/s at 1.4 s.
TEST(Dip, IsBelowTheLineAround) {
  std::vector<Command> commands;
  for (int i = 0; i < 20; ++i) commands.push_back({.at = 0.1 * i + 0.001, .speed = i == 12 ? 0.45 : 0.5});
  EXPECT_NEAR(dip(commands, 1.05), 0.05, 1e-12);
  EXPECT_EQ(dip(commands, 0.05), 0.0);
  EXPECT_EQ(dip(commands, 5.0), 0.0) << "nothing was commanded there";
}

// Braking evenly with 1 m/s^2 is no dip.
TEST(Dip, IsNoneInAnEvenFall) {
  std::vector<Command> commands;
  for (int i = 0; i < 20; ++i) commands.push_back({.at = 0.1 * i, .speed = 2.0 - 0.1 * i});
  EXPECT_NEAR(dip(commands, 0.73), 0.0, 1e-12);
}

}  // namespace
}  // namespace nav2
