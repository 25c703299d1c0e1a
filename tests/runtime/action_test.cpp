// Action servers and clients of components, in lock-step over real DDS ends. Expected times and orders follow
// from the rules in lockstep_runner.hpp; states from rcl_action.
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lifecycle_msgs/srv/change_state.hpp>
#include <nav2_msgs/action/navigate_to_pose.hpp>

#include "runtime/host/host.hpp"
#include "runtime/host/lockstep_runner.hpp"
#include "tests/runtime/scripted.hpp"

namespace bw {
namespace {

using lifecycle_msgs::srv::ChangeState;
using nav2_msgs::action::NavigateToPose;
using testing::ElementsAre;
using Handle = GoalHandle<NavigateToPose>;
using Callbacks = ActionCallbacks<NavigateToPose>;

std::int64_t ms(Time t) { return (t - LockstepRunner::kStart).nanoseconds / 1'000'000; }

NavigateToPose::Result result(std::uint16_t code) {
  NavigateToPose::Result result;
  result.error_code(code);
  return result;
}

Callbacks callbacks(std::function<void(const Handle&, const Tick&)> on_goal,
                    std::function<void(const Handle&, const Tick&)> on_cancel) {
  return {.on_goal = std::move(on_goal),
          .on_cancel = std::move(on_cancel),
          .abandoned = [](const std::string&) { return result(99); }};
}

/// A server that a script declares, and a client that does at `times` [ms] what `actions` say.
struct Drive {
  using Log = std::vector<std::string>;
  std::function<void(bw::Setup&)> server;
  Duration latency;
  std::map<std::int64_t, std::function<void(const ActionClient<NavigateToPose>&)>> acts;
  Log statuses;

  void go(int length) {
    Graph graph;
    graph.components.push_back(scripted({.name = "server", .latency = latency}, server));
    graph.components.push_back(scripted({.name = "client"}, [this](bw::Setup& setup) {
      const auto client = setup.action_client<NavigateToPose>("go");
      setup.input<action_msgs::msg::GoalStatusArray>(
          "go/_action/status", Qos{.durability = Durability::transient_local},
          [this](const action_msgs::msg::GoalStatusArray& message, const Tick& tick) {
            std::string text = std::to_string(ms(tick.now)) + ":";
            for (const auto& goal : message.status_list()) text += " " + std::to_string(goal.status());
            statuses.push_back(text);
          },
          Need::optional);
      setup.every(Duration::milliseconds(10), "act", [this, client](const Tick& tick) {
        if (const auto act = acts.find(ms(tick.now)); act != acts.end()) act->second(client);
      });
    }));
    Host host(graph, {.clock = ClockMode::lockstep});
    host.run(Duration::milliseconds(length));
  }
};

GoalCallbacks<NavigateToPose> noting(Drive::Log& log) {
  const auto when = [](const Tick& tick) { return std::to_string(ms(tick.now)) + " "; };
  return {.on_acknowledged = [&log, when](
                                 bool accepted,
                                 const Tick& tick) { log.push_back(when(tick) + (accepted ? "yes" : "no")); },
          .on_feedback =
              [&log, when](const NavigateToPose::Feedback& feedback, const Tick& tick) {
                log.push_back(when(tick) + "feedback " + std::to_string(feedback.number_of_recoveries()));
              },
          .on_result =
              [&log, when](GoalStatus status, const NavigateToPose::Result* its, const Tick& tick) {
                log.push_back(when(tick) + "status " + std::to_string(static_cast<int>(status)) + " code " +
                              (its == nullptr ? "none" : std::to_string(its->error_code())));
              }};
}

constexpr Duration kDeadline = Duration::milliseconds(100);

TEST(Action, ABusyComponentDelaysTheResultAndNotTheAcknowledgement) {
  // The server takes 25 ms for each call. Goals come at 10 and 20: each is acknowledged at once. The first
  // call begins at 10 and says at 35 that the goal is executing, fed back and done; the second one begins at
  // 35 and ends at 60.
  Drive run;
  run.latency = Duration::milliseconds(25);
  run.server = [](bw::Setup& setup) {
    setup.action<NavigateToPose>("go", callbacks(
                                           [](const Handle& goal, const Tick&) {
                                             NavigateToPose::Feedback feedback;
                                             feedback.number_of_recoveries(7);
                                             goal.feedback(feedback);
                                             EXPECT_TRUE(goal.is_open());
                                             goal.succeed(result(0));
                                             EXPECT_FALSE(goal.is_open());
                                             goal.abort(result(1));
                                           },
                                           nullptr));
  };
  Drive::Log log;
  const auto send = [&log](const ActionClient<NavigateToPose>& client) {
    client.send({}, kDeadline, noting(log));
  };
  run.acts = {{10, send}, {20, send}};
  run.go(100);
  EXPECT_THAT(log, ElementsAre("10 yes", "20 yes", "35 feedback 7", "35 status 4 code 0", "60 feedback 7",
                               "60 status 4 code 0"));
  EXPECT_THAT(run.statuses, ElementsAre("10: 1", "20: 1 1", "35: 2 1", "35: 4 1", "60: 4 2", "60: 4 4"));
}

TEST(Action, ACanceledGoalIsCancelingUntilTheComponentSaysSo) {
  Handle held;
  Drive run;
  run.server = [&held](bw::Setup& setup) {
    setup.action<NavigateToPose>("go", callbacks(
                                           [&held](const Handle& goal, const Tick&) {
                                             held = goal;
                                             goal.execute();
                                           },
                                           [&held](const Handle& goal, const Tick&) {
                                             EXPECT_TRUE(goal == held);
                                             EXPECT_TRUE(goal.is_canceling());
                                           }));
    setup.every(Duration::milliseconds(50), "rest", [&held](const Tick&) {
      if (held.is_canceling()) held.canceled(result(5));
    });
  };
  Drive::Log log;
  GoalId id;
  run.acts = {{10, [&](const auto& client) { id = client.send({}, kDeadline, noting(log)); }},
              {20, [&](const auto& client) { client.cancel(id); }}};
  run.go(100);
  EXPECT_THAT(log, ElementsAre("10 yes", "50 status 5 code 5"));
  EXPECT_THAT(run.statuses, ElementsAre("10: 1", "10: 2", "20: 3", "50: 5"));
}

TEST(Action, AnIdIsAcceptedOnceAndAGoalIsPreemptedByItsComponent) {
  Handle held;
  Drive run;
  run.server = [&held](bw::Setup& setup) {
    setup.action<NavigateToPose>("go", callbacks(
                                           [&held](const Handle& goal, const Tick&) {
                                             if (held.is_open()) held.abort(result(3));
                                             held = goal;
                                           },
                                           nullptr));
  };
  Drive::Log first, second;
  run.acts = {{10, [&](const auto& client) { client.send({}, kDeadline, noting(first)); }},
              {20, [&](const auto& client) { client.send({}, kDeadline, noting(second)); }}};
  run.go(30);
  EXPECT_THAT(first, ElementsAre("10 yes", "20 status 6 code 3"));
  EXPECT_THAT(second, ElementsAre("20 yes"));
}

TEST(Action, ACancelOfSeveralGoalsReachesTheComponentForEach) {
  Drive run;
  run.server = [](bw::Setup& setup) {
    setup.action<NavigateToPose>(
        "go", callbacks([](const Handle&, const Tick&) {},
                        [](const Handle& goal, const Tick&) { goal.canceled(result(5)); }));
    const auto cancel = setup.client<action_msgs::srv::CancelGoal>("go/_action/cancel_goal");
    setup.every(Duration::milliseconds(20), "cancel", [cancel](const Tick&) {
      cancel.call({}, kDeadline, [](const action_msgs::srv::CancelGoal::Response*, const Tick&) {});
    });
  };
  Drive::Log first, second;
  run.acts = {{10, [&](const auto& client) {
                 client.send({}, kDeadline, noting(first));
                 client.send({}, kDeadline, noting(second));
               }}};
  run.go(30);
  EXPECT_THAT(first, ElementsAre("10 yes", "20 status 5 code 5"));
  EXPECT_THAT(second, ElementsAre("10 yes", "20 status 5 code 5"));
}

TEST(Action, WhoIsDeactivatedAbortsItsGoalsAndTakesNone) {
  Drive run;
  std::function<void(std::uint8_t)> change;
  run.server = [](bw::Setup& setup) {
    setup.action<NavigateToPose>("go", callbacks([](const Handle&, const Tick&) {}, nullptr));
  };
  Drive::Log first, second, third;
  Graph graph;
  graph.components.push_back(scripted({.name = "server"}, run.server));
  graph.components.push_back(scripted({.name = "client"}, [&](bw::Setup& setup) {
    const auto client = setup.action_client<NavigateToPose>("go");
    const auto transition = setup.client<ChangeState>("server/change_state");
    const auto ask = [transition](std::uint8_t id) {
      ChangeState::Request request;
      request.transition().id(id);
      transition.call(request, kDeadline, [](const ChangeState::Response*, const Tick&) {});
    };
    constexpr std::uint8_t kActivate = 3, kDeactivate = 4;
    setup.every(Duration::milliseconds(10), "act", [&, client, ask](const Tick& tick) {
      if (ms(tick.now) == 10) client.send({}, kDeadline, noting(first));
      if (ms(tick.now) == 20) ask(kDeactivate);
      if (ms(tick.now) == 30) client.send({}, kDeadline, noting(second));
      if (ms(tick.now) == 40) ask(kActivate);
      if (ms(tick.now) == 50) client.send({}, kDeadline, noting(third));
    });
  }));
  Host host(graph, {.clock = ClockMode::lockstep});
  host.run(Duration::milliseconds(60));
  EXPECT_THAT(first, ElementsAre("10 yes", "20 status 6 code 99"));
  EXPECT_THAT(second, ElementsAre("30 no"));
  EXPECT_THAT(third, ElementsAre("50 yes"));
}

TEST(Action, ARemapMovesAllOfIt) {
  Drive run;
  std::vector<std::string> heard;
  Graph graph;
  ComponentNode server{.name = "server", .node_namespace = "/robot1"};
  server.remaps.push_back({.from = "go", .to = "/elsewhere", .where = {}});
  graph.components.push_back(scripted(server, [](bw::Setup& setup) {
    setup.action<NavigateToPose>(
        "go", callbacks([](const Handle& goal, const Tick&) { goal.succeed(result(0)); }, nullptr));
  }));
  graph.components.push_back(scripted({.name = "client"}, [&](bw::Setup& setup) {
    const auto client = setup.action_client<NavigateToPose>("/elsewhere");
    setup.every(Duration::milliseconds(50), "act",
                [&, client](const Tick&) { client.send({}, kDeadline, noting(heard)); });
  }));
  Host host(graph, {.clock = ClockMode::lockstep});
  host.run(Duration::milliseconds(60));
  EXPECT_THAT(heard, ElementsAre("50 yes", "50 status 4 code 0"));
}

}  // namespace
}  // namespace bw
