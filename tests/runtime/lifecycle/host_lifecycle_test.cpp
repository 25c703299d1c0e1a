// Transitions of scripted components in lock-step. Requests are made at whole milliseconds and take none:
// expected times and orders follow from that, from rank order, and from README's rules for what is not
// active.
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lifecycle_msgs/msg/transition_event.hpp>
#include <rcl_interfaces/srv/set_parameters.hpp>
#include <std_srvs/srv/trigger.hpp>

#include "tests/runtime/lifecycle/scripted_graph.hpp"

namespace bw::test {
namespace {

using rcl_interfaces::srv::SetParameters;
using std_srvs::srv::Trigger;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Publishes its count on `topic` every 10 ms.
Script ticker(const std::string& topic) {
  return {.configure = [topic](bw::Setup& setup) {
    setup.every(Duration::milliseconds(10), "tick", [out = setup.output<Float64>(topic)](const Tick& tick) {
      out.publish(value(static_cast<double>(tick.sequence)));
    });
  }};
}

/// Writes down what it hears on `topic`: "0@10".
Script listener(Events& heard, const std::string& topic, const Qos& qos = Qos::standard()) {
  return {.configure = [&heard, topic, qos](bw::Setup& setup) {
    setup.input<Float64>(topic, qos, [&heard](const Float64& m, const Tick& tick) {
      heard.push_back(std::to_string(static_cast<int>(m.data())) + "@" + std::to_string(ms(tick.now)));
    });
  }};
}

TEST(Own, ComesUpInTheGivenOrderAndDownBackwards) {
  Events events;
  ScriptedGraph g;
  for (const char* name : {"a", "b", "c"}) g.add(name, [&events, name] { return talker(events, name); });
  g.graph.bring_up = {"c", "a"};
  run(g.graph, 0.01);
  EXPECT_THAT(events, ElementsAre("configure a", "configure b", "configure c",  // as they are loaded
                                  "activate c", "activate a", "activate b", "deactivate b", "deactivate a",
                                  "deactivate c", "cleanup b", "cleanup a", "cleanup c"));
}

TEST(Own, WhoCannotBeActivatedEndsTheRunAndTheOthersAreBroughtToRest) {
  Events events;
  ScriptedGraph g;
  for (const char* name : {"a", "b", "c"}) {
    g.add(name, [&events, name] {
      Script script = talker(events, name);
      if (std::string(name) == "b")
        script.activate = [](const Tick&) { throw std::runtime_error("no such device"); };
      return script;
    });
  }
  RunEnd end;
  run(g.graph, 1.0, {}, &end);
  EXPECT_FALSE(end.ok);
  EXPECT_EQ(end.reason, "b cannot be activated: no such device");
  EXPECT_THAT(events, ElementsAre("configure a", "configure b", "configure c", "activate a", "deactivate a",
                                  "cleanup c", "cleanup b", "cleanup a"));
}

TEST(Own, WhoFailsAtTheEndStopsNobodyElse) {
  Events events;
  ScriptedGraph g;
  g.add("a", [&] { return talker(events, "a"); }).add("b", [&] {
    Script script = talker(events, "b");
    script.deactivate = [](const Tick&) { throw std::runtime_error("stuck"); };
    return script;
  });
  RunEnd end;
  run(g.graph, 0.01, {}, &end);
  EXPECT_EQ(end.reason, "b failed at the end: stuck");
  EXPECT_FALSE(end.ok);
  EXPECT_THAT(events, testing::Contains("deactivate a"));
  EXPECT_THAT(events, testing::Contains("cleanup a"));
}

TEST(Transitions, WhatIsInactiveIsMuteAndDeafAndTicksAnew) {
  // Ticks each 10 ms; inactive from 25 to 47 ms: silent at 30 and 40. Active again: first tick one period
  // later, at 57, and the count goes on.
  Events heard;
  ScriptedGraph g;
  g.add("source", [] { return ticker("a"); }).add("sink", [&] { return listener(heard, "a"); });
  EXPECT_THAT(run(g.graph, 0.07, {{25, "source", "deactivate"}, {47, "source", "activate"}}),
              ElementsAre("deactivate source: ok", "activate source: ok"));
  EXPECT_THAT(heard, ElementsAre("0@10", "1@20", "2@57", "3@67"));

  // The other way round: what came at 30 and 40 is not kept for later.
  heard.clear();
  run(g.graph, 0.06, {{25, "sink", "deactivate"}, {47, "sink", "activate"}});
  EXPECT_THAT(heard, ElementsAre("0@10", "1@20", "4@50", "5@60"));
}

TEST(Transitions, WhatIsActiveAgainHasNoMessagesOfBefore) {
  // Messages at 10 and 20 only; the map is latched.
  Events seen;
  ScriptedGraph g;
  g.add("source", [] {
     return Script{.configure = [](bw::Setup& setup) {
       setup.every(Duration::milliseconds(10), "tick",
                   [a = setup.output<Float64>("a"),
                    map = setup.output<Float64>("map", Qos::latched())](const Tick& tick) {
                     if (tick.sequence < 2) a.publish(value(1));
                     if (tick.sequence == 0) map.publish(value(2));
                   });
     }};
   }).add("user", [&seen] {
    return Script{.configure = [&seen](bw::Setup& setup) {
      setup.every(Duration::milliseconds(15), "tick",
                  [&seen, a = setup.latest<Float64>("a", Qos::standard()),
                   map = setup.latest<Float64>("map", Qos::latched())](const Tick& tick) {
                    seen.push_back(std::to_string(ms(tick.now)) + (a ? " a" : "") + (map ? " map" : ""));
                  });
    }};
  });
  run(g.graph, 0.06, {{31, "user", "deactivate"}, {32, "user", "activate"}});
  EXPECT_THAT(seen, ElementsAre("15 a map", "30 a map", "47 map"));
}

TEST(Transitions, DeactivationMayPublishALastTimeAndSeesStop) {
  Events heard;
  ScriptedGraph g;
  g.add("base", [] {
     auto out = std::make_shared<Output<Float64>>();
     Script script;
     script.configure = [out](bw::Setup& setup) { *out = setup.command<Float64>("motor"); };
     script.deactivate = [out](const Tick& tick) {
       out->publish(value(tick.health == Health::stop ? 7 : -1));
     };
     script.cleanup = [out] { out->publish(value(99)); };
     return script;
   }).add("sink", [&] { return listener(heard, "motor", Qos::command()); });
  run(g.graph, 0.05, {{10, "base", "deactivate"}, {20, "base", "cleanup"}});
  EXPECT_THAT(heard, ElementsAre("7@10"));
}

TEST(Transitions, ANewInstanceTakesTheEndsOfTheOneBefore) {
  int instances = 0;
  Events heard, latched;
  ScriptedGraph g;
  g.add("source",
        [&instances] {
          ++instances;
          return ticker("a");
        })
      .add(
          "map",
          [] {
            auto out = std::make_shared<Output<Float64>>();
            return Script{
                .configure = [out](bw::Setup& setup) { *out = setup.output<Float64>("map", Qos::latched()); },
                .activate = [out](const Tick&) { out->publish(value(5)); }};
          })
      .add("sink", [&] { return listener(heard, "a"); })
      .add("planner", [&] { return listener(latched, "map", Qos::latched()); });
  const Events answers = run(g.graph, 0.06,
                             {{15, "source", "deactivate"},
                              {16, "source", "cleanup"},
                              {25, "source", "configure"},
                              {26, "source", "activate"},
                              {30, "planner", "deactivate"},
                              {31, "planner", "activate"},
                              {40, "planner", "deactivate"},
                              {41, "planner", "cleanup"},
                              {42, "planner", "configure"},
                              {43, "planner", "activate"}});
  EXPECT_THAT(answers, testing::Each(HasSubstr(": ok")));
  EXPECT_EQ(instances, 2);
  EXPECT_THAT(heard, ElementsAre("0@10", "0@36", "1@46", "2@56")) << "its calls are counted from 0 again";
  EXPECT_THAT(latched, ElementsAre("5@0", "5@43")) << "once by each instance, though it was written once";
}

TEST(Transitions, OtherEndsThanBeforeAreRefused) {
  int instances = 0;
  Events heard;
  ScriptedGraph g;
  g.add("source", [&instances] { return ticker(instances++ == 1 ? "b" : "a"); }).add("sink", [&] {
    return listener(heard, "a");
  });
  EXPECT_THAT(run(g.graph, 0.06,
                  {{15, "source", "deactivate"},
                   {16, "source", "cleanup"},
                   {17, "source", "configure"},
                   {18, "source", "activate"},
                   {25, "source", "configure"},
                   {26, "source", "activate"}}),
              ElementsAre("deactivate source: ok", "cleanup source: ok", "configure source: no",
                          "activate source: no", "configure source: ok", "activate source: ok"));
  EXPECT_EQ(instances, 3);
  EXPECT_THAT(heard, ElementsAre("0@10", "0@36", "1@46", "2@56"));
}

TEST(Transitions, FewerEndsThanBeforeAreRefusedToo) {
  int instances = 0;
  ScriptedGraph g;
  g.add("source", [&instances] { return instances++ == 0 ? ticker("a") : Script{}; });
  EXPECT_THAT(
      run(g.graph, 0.03, {{5, "source", "deactivate"}, {6, "source", "cleanup"}, {7, "source", "configure"}}),
      ElementsAre("deactivate source: ok", "cleanup source: ok", "configure source: no"));
}

TEST(Transitions, FailuresLeaveTheStateThatIsTrue) {
  // configure, activate: where it was; deactivate: what is left is unknown, so it is unconfigured.
  bool fails = false;
  const auto or_throw = [&fails] {
    if (fails) throw std::runtime_error("told to");
  };
  ScriptedGraph g;
  g.add("a", [&] {
    return Script{.configure = [&](bw::Setup&) { or_throw(); },
                  .activate = [&](const Tick&) { or_throw(); },
                  .deactivate = [&](const Tick&) { or_throw(); },
                  .cleanup = [] {}};
  });
  g.add("switch", [&] {
    return Script{.configure = [&](bw::Setup& setup) {
      setup.every(Duration::milliseconds(10), "switch",
                  [&](const Tick& tick) { fails = tick.sequence % 2 == 0; });
    }};
  });
  EXPECT_THAT(run(g.graph, 0.08,
                  {{15, "a", "deactivate"},  // fails: unconfigured
                   {16, "a", "activate"},    // so there is no such transition
                   {17, "a", "configure"},   // fails
                   {25, "a", "configure"},
                   {35, "a", "activate"},  // fails: inactive
                   {45, "a", "activate"},
                   {46, "a", "shutdown"},
                   {47, "a", "configure"}}),
              ElementsAre("deactivate a: no", "activate a: no", "configure a: no", "configure a: ok",
                          "activate a: no", "activate a: ok", "shutdown a: ok", "configure a: no"));
}

TEST(Transitions, AreToldStepByStepAndOnlyWhenAsked) {
  std::vector<std::string> told;
  const auto watcher = [&told] {
    return Script{.configure = [&told](bw::Setup& setup) {
      setup.input<lifecycle_msgs::msg::TransitionEvent>(
          "/a/transition_event", Qos::standard(),
          [&told](const auto& event, const Tick& tick) {
            told.push_back(fmt::format("{} [{}] {}>{}", event.transition().label(), event.transition().id(),
                                       event.start_state().label(), event.goal_state().label()));
            EXPECT_EQ(event.timestamp(), static_cast<std::uint64_t>(tick.now.nanoseconds));
          },
          Need::optional);
    }};
  };
  ScriptedGraph g;
  g.add("a", [] { return Script{.deactivate = [](const Tick&) { throw std::runtime_error("told to"); }}; });
  g.add("watcher", watcher);
  run(g.graph, 0.02);
  EXPECT_THAT(told, IsEmpty());
  run(g.graph, 0.02, {{5, "a", "deactivate"}, {6, "a", "shutdown"}});
  EXPECT_THAT(told, ElementsAre("deactivate [4] active>deactivating",
                                "transition_error [42] deactivating>errorprocessing",
                                "transition_success [60] errorprocessing>unconfigured",
                                "shutdown [5] unconfigured>shuttingdown",
                                "transition_success [50] shuttingdown>finalized"));
}

TEST(Transitions, AServiceThatChangesSomethingIsRefusedWhileNotActive) {
  Events answers;
  const auto server = [] {
    return Script{.configure = [](bw::Setup& setup) {
      const auto answer = [](const Trigger::Request&, const Tick&) {
        Trigger::Response response;
        response.success(true);
        response.message("done");
        return response;
      };
      setup.service<Trigger>("work", answer, [](const std::string& reason) {
        Trigger::Response response;
        response.message(reason);
        return response;
      });
      setup.service<Trigger>("tell", answer);
    }};
  };
  const auto client = [&answers] {
    return Script{.configure = [&answers](bw::Setup& setup) {
      for (const char* service : {"work", "tell"}) {
        setup.every(
            Duration::milliseconds(10), service, [&answers, c = setup.client<Trigger>(service)](const Tick&) {
              c.call({}, Duration::milliseconds(5),
                     [&answers](const Trigger::Response* response, const Tick& t) {
                       answers.push_back(std::to_string(ms(t.now)) + " " +
                                         (response == nullptr ? "none" : "'" + response->message() + "'"));
                     });
            });
      }
    }};
  };
  ScriptedGraph g;
  g.add("server", server).add("client", client);
  run(g.graph, 0.035, {{15, "server", "deactivate"}, {25, "server", "cleanup"}});
  EXPECT_THAT(answers, ElementsAre("10 'done'", "10 'done'", "20 'server is not active (inactive)'",
                                   "20 'done'", "30 'server is not active (unconfigured)'", "30 ''"));
}

struct Gain {
  double gain = 1.0;
  void fields(auto& v) { v("gain", gain, {.min = 0, .max = 10, .doc = "of a test"}); }
};

/// Sets /a's gain at a time.
class Setter final : public Component {
 public:
  Setter(std::unique_ptr<Component> other, int at_ms, double gain)
      : other_(std::move(other)), at_ms_(at_ms), gain_(gain) {}
  void configure(bw::Setup& setup) override {
    other_->configure(setup);
    setup.every(
        Duration::milliseconds(1), "set",
        [this, c = setup.client<SetParameters>("/a/set_parameters", Need::optional)](const Tick& tick) {
          if (ms(tick.now) != at_ms_) return;
          SetParameters::Request request;
          auto& parameter = request.parameters().emplace_back();
          parameter.name("gain");
          parameter.value().type(3);
          parameter.value().double_value(gain_);
          c.call(request, Duration::milliseconds(5), [](const auto* response, const Tick&) {
            ASSERT_NE(response, nullptr);
            EXPECT_TRUE(response->results().at(0).successful()) << response->results().at(0).reason();
          });
        });
  }

 private:
  std::unique_ptr<Component> other_;
  int at_ms_;
  double gain_;
};

TEST(Parameters, WhatIsChangedWhileUnconfiguredTheNextInstanceReads) {
  for (const bool is_external : {false, true}) {
    std::vector<double> read;
    ScriptedGraph g;
    g.add("a", [&read] {
      return Script{
          .configure = [&read](bw::Setup& setup) { read.push_back(setup.parameters<Gain>().gain); }};
    });
    g.graph.settings.external_lifecycle = is_external;
    Events answers;
    std::vector<Asker::Request> requests = {{10, "a", "configure"}, {11, "a", "activate"}};
    if (!is_external) requests.insert(requests.begin(), {{2, "a", "deactivate"}, {3, "a", "cleanup"}});
    Host host(g.graph, {.clock = ClockMode::lockstep, .accept_inputs = true},
              with(std::make_unique<Setter>(std::make_unique<Asker>(requests, answers), 5, 7.5)));
    host.run(Duration::milliseconds(20));
    EXPECT_THAT(answers, testing::Each(HasSubstr(": ok")));
    EXPECT_THAT(read, ElementsAre(1.0, 7.5)) << (is_external ? "external" : "own");
  }
}

TEST(External, WaitsInLockstepOnlyForAManagerThatMayCome) {
  Events events;
  ScriptedGraph g;
  g.add("a", [&] { return talker(events, "a"); });
  g.graph.settings.external_lifecycle = true;
  try {
    run(g.graph, 0.01);
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("without --accept-inputs"));
  }
}

TEST(External, NobodyIsActiveUntilAManagerComes) {
  Events events, answers;
  ScriptedGraph g;
  g.add("a", [&] { return talker(events, "a"); }).add("b", [&] { return talker(events, "b"); });
  g.graph.settings.external_lifecycle = true;
  {
    Host host(
        g.graph, {.clock = ClockMode::lockstep, .accept_inputs = true},
        with(std::make_unique<Asker>(
            std::vector<Asker::Request>{{5, "a", "activate"}, {10, "a", "configure"}, {11, "a", "activate"}},
            answers)));
    EXPECT_TRUE(host.run(Duration::milliseconds(20)).ok);
  }
  EXPECT_THAT(answers, ElementsAre("activate a: no", "configure a: ok", "activate a: ok"));
  // The instance that was made for the check of the graph serves; b is never more than that.
  EXPECT_THAT(events, ElementsAre("configure a", "configure b", "activate a", "deactivate a", "cleanup a"));
}

}  // namespace
}  // namespace bw::test
