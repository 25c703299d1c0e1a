// Goals of other participants: in lock-step as every change from outside, in real time however busy the
// component is.
#include <future>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav2_msgs/action/navigate_to_pose.hpp>
#include <std_msgs/msg/float64.hpp>
#include <std_srvs/srv/trigger.hpp>

#include "runtime/host/host.hpp"
#include "runtime/host/lockstep_runner.hpp"
#include "runtime/ros/dds_names.hpp"
#include "runtime/ros/service_call.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/runtime/from_outside.hpp"
#include "tests/runtime/scripted.hpp"

namespace bw {
namespace {

using action_msgs::srv::CancelGoal;
using nav2_msgs::action::NavigateToPose;
using std_srvs::srv::Trigger;
using Handle = GoalHandle<NavigateToPose>;

constexpr std::chrono::seconds kLong{10};

GoalId id(std::uint8_t n) { return {n}; }

std::optional<NavigateToPose::SendGoal::Response> send(dds::Participant& participant, std::uint8_t n) {
  NavigateToPose::SendGoal::Request request;
  request.goal_id().uuid(id(n));
  return call_service<NavigateToPose::SendGoal>(participant, "/go/_action/send_goal", request, kLong);
}

std::optional<CancelGoal::Response> cancel(dds::Participant& participant, std::uint8_t n) {
  CancelGoal::Request request;
  request.goal_info().goal_id().uuid(id(n));
  return call_service<CancelGoal>(participant, "/go/_action/cancel_goal", request, kLong);
}

std::optional<NavigateToPose::GetResult::Response> result(dds::Participant& participant, std::uint8_t n) {
  NavigateToPose::GetResult::Request request;
  request.goal_id().uuid(id(n));
  return call_service<NavigateToPose::GetResult>(participant, "/go/_action/get_result", request, kLong);
}

/// A server whose goals a script takes, which ends its run at `done`.
Graph graph_of(std::function<void(const Handle&, const Tick&)> on_goal) {
  Graph graph;
  graph.components.push_back(scripted({.name = "server"}, [on_goal](Setup& setup) {
    setup.action<NavigateToPose>("go",
                                 {.on_goal = on_goal,
                                  .on_cancel = [](const Handle& goal, const Tick&) { goal.canceled({}); },
                                  .abandoned = [](const std::string&) { return NavigateToPose::Result(); }});
    auto out = setup.output<std_msgs::msg::Float64>("ticks");
    setup.every(Duration::milliseconds(10), "tick", [out](const Tick&) { out.publish({}); });
  }));
  graph.components.push_back(scripted({.name = "end", .lane = "end"}, [](Setup& setup) {
    setup.service<Trigger>("done", [finish = setup.finish_run()](const Trigger::Request&, const Tick&) {
      finish(true, "done");
      return Trigger::Response();
    });
  }));
  return graph;
}

TEST(ActionOutside, ARunInLockstepRefusesGoalsAndTellsResults) {
  int goals = 0;
  Host host(graph_of([&goals](const Handle&, const Tick&) { ++goals; }),
            {.clock = ClockMode::lockstep, .pace = 1.0});
  const FromOutside outside([](dds::Participant& participant) {
    const auto sent = send(participant, 1);
    ASSERT_TRUE(sent.has_value());
    EXPECT_FALSE(sent->accepted());
    const auto canceled = cancel(participant, 1);
    ASSERT_TRUE(canceled.has_value());
    EXPECT_EQ(canceled->return_code(), 1) << "rejected";
    const auto told = result(participant, 1);
    ASSERT_TRUE(told.has_value());
    EXPECT_EQ(told->status(), 0) << "unknown";
    EXPECT_TRUE(call_service<Trigger>(participant, "/done", {}, kLong).has_value());
  });
  EXPECT_EQ(host.run(Duration::seconds(20)).reason, "done");
  EXPECT_EQ(goals, 0);
  EXPECT_FALSE(host.was_changed_from_outside());
}

TEST(ActionOutside, AcceptedGoalsEnterAtAnInstantOfTheRun) {
  std::vector<std::int64_t> taken_at;
  Host host(graph_of([&taken_at](const Handle&, const Tick& tick) {
              taken_at.push_back((tick.now - LockstepRunner::kStart).nanoseconds / 1'000'000);
            }),
            {.clock = ClockMode::lockstep, .pace = 1.0, .accept_inputs = true});
  const FromOutside outside([](dds::Participant& participant) {
    const auto sent = send(participant, 1);
    ASSERT_TRUE(sent.has_value());
    EXPECT_TRUE(sent->accepted());
    const auto canceled = cancel(participant, 1);
    ASSERT_TRUE(canceled.has_value());
    EXPECT_EQ(canceled->goals_canceling().size(), 1U);
    const auto told = result(participant, 1);
    ASSERT_TRUE(told.has_value());
    EXPECT_EQ(told->status(), 5) << "canceled";
    EXPECT_TRUE(call_service<Trigger>(participant, "/done", {}, kLong).has_value());
  });
  EXPECT_EQ(host.run(Duration::seconds(20)).reason, "done");
  ASSERT_EQ(taken_at.size(), 1U);
  EXPECT_EQ(taken_at[0] % 10, 0) << "an instant at which something happens";
  EXPECT_TRUE(host.was_changed_from_outside());
}

// The component is held inside of its first goal until the second one and a cancel are answered: were they
// answered on its lane, nobody would go on.
TEST(ActionOutside, ABusyComponentDelaysNoAcknowledgement) {
  std::promise<void> answered;
  std::vector<std::uint8_t> goals;
  Host host(graph_of([&, wait = answered.get_future().share()](const Handle& goal, const Tick&) {
              goals.push_back(goal.id()[0]);
              EXPECT_EQ(wait.wait_for(kLong), std::future_status::ready);
              goal.succeed({});
            }),
            {.clock = ClockMode::wall});
  const FromOutside outside([&answered](dds::Participant& participant) {
    const auto first = send(participant, 1);
    const auto second = send(participant, 2);
    const auto canceled = cancel(participant, 1);
    answered.set_value();
    ASSERT_TRUE(first && second && canceled);
    EXPECT_TRUE(first->accepted() && second->accepted());
    EXPECT_EQ(canceled->goals_canceling().size(), 1U);
    const auto told = result(participant, 2);
    ASSERT_TRUE(told.has_value());
    EXPECT_EQ(told->status(), 4) << "succeeded";
    EXPECT_TRUE(call_service<Trigger>(participant, "/done", {}, kLong).has_value());
  });
  EXPECT_EQ(host.run(Duration::seconds(20)).reason, "done");
  EXPECT_THAT(goals, testing::ElementsAre(1, 2));
}

TEST(ActionOutside, OpenGoalsEndWithTheRun) {
  Host host(graph_of([](const Handle& goal, const Tick&) { goal.execute(); }), {.clock = ClockMode::wall});
  const FromOutside outside([](dds::Participant& participant) {
    using Array = action_msgs::msg::GoalStatusArray;
    const auto status =
        participant.create_reader({.topic = dds_topic("/go/_action/status"),
                                   .type = std::string(MessageTraits<Array>::dds_name),
                                   .qos = {.durability = Durability::transient_local, .depth = 10},
                                   .user_data = {}},
                                  [] {});
    ASSERT_TRUE(send(participant, 1).has_value());
    EXPECT_TRUE(call_service<Trigger>(participant, "/done", {}, kLong).has_value());
    int last = 0;
    EXPECT_TRUE(test::eventually([&] {
      dds::Sample sample;
      Array message;
      while (status->take(sample)) {
        if (deserialize(sample.cdr, message)) last = message.status_list().at(0).status();
      }
      return last == 6;
    })) << "aborted; it is "
        << last;
  });
  EXPECT_EQ(host.run(Duration::seconds(20)).reason, "done");
}

}  // namespace
}  // namespace bw
