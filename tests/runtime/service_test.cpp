// Services and clients of components, in lock-step over real DDS ends. Expected times and orders follow from
// the rules in lockstep_runner.hpp.
#include "runtime/service.hpp"

#include <functional>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <std_msgs/msg/float64.hpp>
#include <std_srvs/srv/set_bool.hpp>
#include <std_srvs/srv/trigger.hpp>

#include "runtime/host/host.hpp"
#include "runtime/host/lockstep_runner.hpp"
#include "runtime/registry.hpp"
#include "runtime/ros/service_call.hpp"
#include "tests/runtime/from_outside.hpp"
#include "tests/runtime/scripted.hpp"

namespace bw {
namespace {

using std_srvs::srv::SetBool;
using std_srvs::srv::Trigger;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Trigger::Response said(const std::string& text) {
  Trigger::Response response;
  response.success(true);
  response.message(text);
  return response;
}

/// A graph of one server, `server`, whose services a script declares.
Graph server_graph(std::function<void(Setup&)> script, Duration latency = {}) {
  Graph graph;
  graph.components.push_back(scripted({.name = "server", .latency = latency}, std::move(script)));
  return graph;
}

std::int64_t ms(Time t) { return (t - LockstepRunner::kStart).nanoseconds / 1'000'000; }

/// Calls `ask` of the server each 10 ms and notes what came when.
std::function<void(Setup&)> asker(std::vector<std::string>& heard, Duration deadline) {
  return [&heard, deadline](Setup& setup) {
    const Client<Trigger> client = setup.client<Trigger>("ask");
    setup.every(Duration::milliseconds(10), "tick", [&heard, client, deadline](const Tick& tick) {
      client.call({}, deadline,
                  [&heard, asked = ms(tick.now)](const Trigger::Response* reply, const Tick& t) {
                    heard.push_back(std::to_string(asked) + ">" + std::to_string(ms(t.now)) + " " +
                                    (reply == nullptr ? "nothing" : reply->message()));
                  });
    });
  };
}

TEST(Service, AnImmediateReplyComesAtTheInstantOfTheRequest) {
  std::vector<std::string> heard;
  Graph graph = server_graph([](bw::Setup& setup) {
    setup.service<Trigger>("ask", [](const Trigger::Request&, const Tick& tick) {
      return said("at " + std::to_string(ms(tick.now)));
    });
  });
  graph.components.push_back(scripted({.name = "asker"}, asker(heard, Duration::milliseconds(5))));
  Host host(graph, {.clock = ClockMode::lockstep});
  host.run(Duration::milliseconds(20));
  EXPECT_THAT(heard, ElementsAre("10>10 at 10", "20>20 at 20"));
}

TEST(Service, AReplyWaitsForTheLatencyOfItsComponent) {
  // The server works for 25 ms on each request: 10 -> 35; that of 20 waits until 35 and is answered at 60.
  std::vector<std::string> heard;
  Graph graph = server_graph(
      [](bw::Setup& setup) {
        setup.service<Trigger>("ask", [](const Trigger::Request&, const Tick&) { return said("ok"); });
      },
      Duration::milliseconds(25));
  graph.components.push_back(scripted({.name = "asker"}, asker(heard, Duration::milliseconds(100))));
  Host host(graph, {.clock = ClockMode::lockstep});
  host.run(Duration::milliseconds(60));
  EXPECT_THAT(heard, ElementsAre("10>35 ok", "20>60 ok"));
}

TEST(Service, AReplyMayBeGivenLaterAndALateOneIsNothing) {
  // The server answers the first request at 30 ms. The client waits 15 ms: nothing at 25; later replies of
  // unknown calls are not heard.
  std::vector<std::string> heard;
  std::vector<Reply<Trigger>> waiting;
  Graph graph = server_graph([&waiting](bw::Setup& setup) {
    setup.service<Trigger>("ask", [&waiting](const Trigger::Request&, const Reply<Trigger>& reply,
                                             const Tick&) { waiting.push_back(reply); });
    setup.every(Duration::milliseconds(30), "late", [&waiting](const Tick&) {
      for (const Reply<Trigger>& reply : waiting) reply(said("late"));
      waiting.clear();
    });
  });
  graph.components.push_back(scripted({.name = "asker"}, asker(heard, Duration::milliseconds(15))));
  Host host(graph, {.clock = ClockMode::lockstep});
  host.run(Duration::milliseconds(40));
  // Asked at 10: too late at 25. Asked at 20 and, in rank order after the server's tick, at 30: 30 for the
  // first of them.
  EXPECT_THAT(heard, ElementsAre("10>25 nothing", "20>30 late"));
}

TEST(Service, AClientWithoutServerHearsNothingAfterItsDeadline) {
  std::vector<std::string> heard;
  Graph graph;
  graph.components.push_back(scripted({.name = "asker"}, [&heard](bw::Setup& setup) {
    const Client<Trigger> client = setup.client<Trigger>("ask", Need::optional);
    setup.every(Duration::milliseconds(10), "tick", [&heard, client](const Tick& tick) {
      EXPECT_FALSE(client.is_ready());
      client.call({}, Duration::milliseconds(5), [&heard](const Trigger::Response* reply, const Tick& t) {
        EXPECT_EQ(reply, nullptr);
        heard.push_back(std::to_string(ms(t.now)));
      });
      (void)tick;
    });
  }));
  Host host(graph, {.clock = ClockMode::lockstep});
  host.run(Duration::milliseconds(26));
  EXPECT_THAT(heard, ElementsAre("15", "25"));
}

TEST(Service, AGraphWithoutTheServerIsRefused) {
  Graph graph;
  graph.components.push_back(
      scripted({.name = "asker"}, [](bw::Setup& setup) { setup.client<Trigger>("ask"); }));
  try {
    Host host(graph, {.clock = ClockMode::lockstep});
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("asker.ask: nobody offers the service /ask"));
  }
}

TEST(Service, TwoServersOfOneNameAreRefused) {
  const auto script = [](bw::Setup& setup) {
    setup.service<Trigger>("ask", [](const Trigger::Request&, const Tick&) { return said(""); });
  };
  Graph graph = server_graph(script);
  graph.components.push_back(scripted({.name = "second"}, script));
  try {
    Host host(graph, {.clock = ClockMode::lockstep});
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/ask is a service and has a server already: server"));
  }
}

constexpr std::chrono::seconds kLong{10};

/// A server with a service that tells how often it was switched, and one that switches; ends its run at
/// `done`.
Graph switch_graph(std::vector<std::int64_t>& switched_at) {
  return server_graph([&switched_at](Setup& setup) {
    setup.service<Trigger>("count", [&switched_at](const Trigger::Request&, const Tick&) {
      return said(std::to_string(switched_at.size()));
    });
    const auto answer = [](bool ok, const std::string& text) {
      SetBool::Response response;
      response.success(ok);
      response.message(text);
      return response;
    };
    setup.service<SetBool>(
        "switch",
        [&switched_at, answer](const SetBool::Request& request, const Tick& tick) {
          switched_at.push_back(ms(tick.now));
          return answer(true, request.data() ? "on" : "off");
        },
        [answer](const std::string& reason) { return answer(false, reason); });
    setup.service<Trigger>("done", [finish = setup.finish_run()](const Trigger::Request&, const Tick&) {
      finish(true, "done");
      return said("");
    });
    auto out = setup.output<std_msgs::msg::Float64>("ticks");
    setup.every(Duration::milliseconds(10), "tick", [out, &switched_at](const Tick&) {
      std_msgs::msg::Float64 message;
      message.data(static_cast<double>(switched_at.size()));
      out.publish(message);
    });
  });
}

SetBool::Request on() {
  SetBool::Request request;
  request.data(true);
  return request;
}

TEST(Outside, ARunInLockstepAnswersWhatAsksAndRefusesWhatChanges) {
  std::vector<std::int64_t> switched_at;
  Host host(switch_graph(switched_at), {.clock = ClockMode::lockstep, .pace = 1.0});
  const FromOutside outside([](dds::Participant& participant) {
    const auto refused = call_service<SetBool>(participant, "/switch", on(), kLong);
    ASSERT_TRUE(refused.has_value());
    EXPECT_FALSE(refused->success());
    EXPECT_THAT(refused->message(), HasSubstr("--accept-inputs"));
    const auto count = call_service<Trigger>(participant, "/count", {}, kLong);
    ASSERT_TRUE(count.has_value());
    EXPECT_EQ(count->message(), "0");
    EXPECT_TRUE(call_service<Trigger>(participant, "/done", {}, kLong).has_value());
  });
  EXPECT_EQ(host.run(Duration::seconds(20)).reason, "done");
  EXPECT_THAT(switched_at, IsEmpty());
  EXPECT_FALSE(host.was_changed_from_outside());
}

TEST(Outside, WhatIsAcceptedEntersAtAnInstantOfTheRun) {
  std::vector<std::int64_t> switched_at;
  Host host(switch_graph(switched_at), {.clock = ClockMode::lockstep, .pace = 1.0, .accept_inputs = true});
  const FromOutside outside([](dds::Participant& participant) {
    for (int i = 0; i < 3; ++i) {
      const auto accepted = call_service<SetBool>(participant, "/switch", on(), kLong);
      ASSERT_TRUE(accepted.has_value());
      EXPECT_EQ(accepted->message(), "on");
    }
    EXPECT_TRUE(call_service<Trigger>(participant, "/done", {}, kLong).has_value());
  });
  EXPECT_EQ(host.run(Duration::seconds(20)).reason, "done");
  ASSERT_EQ(switched_at.size(), 3U);
  for (const std::int64_t at : switched_at) EXPECT_EQ(at % 10, 0) << "an instant at which something happens";
  EXPECT_TRUE(host.was_changed_from_outside());
}

TEST(Outside, ACallInRealTimeIsAnsweredOnTheLaneOfItsComponent) {
  std::vector<std::int64_t> switched_at;
  Host host(switch_graph(switched_at), {.clock = ClockMode::wall});
  const FromOutside outside([](dds::Participant& participant) {
    for (int i = 0; i < 3; ++i) {
      const auto accepted = call_service<SetBool>(participant, "/switch", on(), kLong);
      ASSERT_TRUE(accepted.has_value());
      EXPECT_TRUE(accepted->success());
    }
    const auto count = call_service<Trigger>(participant, "/count", {}, kLong);
    ASSERT_TRUE(count.has_value());
    EXPECT_EQ(count->message(), "3");
    EXPECT_TRUE(call_service<Trigger>(participant, "/done", {}, kLong).has_value());
  });
  EXPECT_EQ(host.run(Duration::seconds(30)).reason, "done");
  EXPECT_EQ(switched_at.size(), 3U);
}

TEST(Outside, ClientsThatOnlyAskLeaveTheHashAsItIs) {
  const auto hash_of_run = [](const std::function<void(dds::Participant&)>& calls) {
    std::vector<std::int64_t> switched_at;
    Host host(switch_graph(switched_at), {.clock = ClockMode::lockstep, .pace = 2.0});
    std::optional<FromOutside> outside;
    if (calls) outside.emplace(calls);
    host.run(Duration::seconds(4));
    return host.samples_sha256();
  };
  int answers = 0;
  const std::string watched = hash_of_run([&answers](dds::Participant& participant) {
    while (answers < 20 && call_service<Trigger>(participant, "/count", {}, std::chrono::seconds(2)))
      ++answers;
  });
  EXPECT_EQ(answers, 20);
  EXPECT_EQ(hash_of_run(nullptr), watched);
}

}  // namespace
}  // namespace bw
