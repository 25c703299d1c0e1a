// What goes wrong on purpose, in lock-step and in real time. The source publishes 0, 1, 2, ... at 10, 20, 30, ... ms.
#include <atomic>
#include <string>
#include <vector>

#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/fault.hpp"
#include "tests/runtime/test_graph.hpp"

namespace bw {

struct Doubled final : Fault {
  void configure(FaultSetup& setup) override {
    setup.messages<std_msgs::msg::Float64>("a", [](std_msgs::msg::Float64& message, const FaultTick&) {
      message.data(2.0 * message.data());
      return kPasses;
    });
  }
};

BW_FAULT(Doubled, "doubled", "a test's own")

namespace {

using Float64 = std_msgs::msg::Float64;
using Array = diagnostic_msgs::msg::DiagnosticArray;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::function<void(Setup&)> writes_down(std::vector<std::string>& heard, const std::string& topic = "a") {
  return [&heard, topic](bw::Setup& setup) {
    setup.input<Float64>(topic, Qos::standard(), [&heard](const Float64& m, const Tick& tick) {
      heard.push_back(std::to_string(static_cast<int>(m.data())) + "@" + std::to_string(ms(tick.now)));
    });
  };
}

std::vector<std::string> heard_with(const std::string& faults, double seconds = 0.05) {
  std::vector<std::string> heard;
  TestGraph graph;
  graph.faults(faults).add({.name = "source"}, ticker("a", 10)).add({.name = "sink"}, writes_down(heard));
  graph.run(seconds);
  return heard;
}

TEST(Faults, LoseMessagesInTheirTimeOnly) {
  EXPECT_THAT(heard_with("f: {kind: lost, topic: a, from: 20ms, for: 20ms}"),
              ElementsAre("0@10", "3@40", "4@50"));
  EXPECT_THAT(heard_with("f: {kind: lost, topic: a}"), IsEmpty());
  EXPECT_THAT(heard_with("f: {kind: lost, topic: a, from: 20ms, for: 10ms, every: 20ms}"),
              ElementsAre("0@10", "2@30", "4@50"));
}

// Those of 10 and 20 ms are due at 35 and 45: they come with the next step of 10 ms, behind what is said then.
TEST(Faults, HoldMessagesBack) {
  EXPECT_THAT(heard_with("f: {kind: late, topic: a, for: 25ms, parameters: {delay: 0.025}}"),
              ElementsAre("2@30", "3@40", "0@40", "4@50", "1@50"));
}

TEST(Faults, OfOnesOwnAreRegisteredByName) {
  EXPECT_THAT(heard_with("doubled: {from: 30ms}"), ElementsAre("0@10", "1@20", "4@30", "6@40", "8@50"));
}

TEST(Faults, ActTogether) {
  EXPECT_THAT(heard_with("doubled: {from: 30ms}\nf: {kind: lost, topic: a, from: 40ms}"),
              ElementsAre("0@10", "1@20", "4@30"));
}

TEST(Faults, ChangeStamps) {
  using Stamped = geometry_msgs::msg::PoseStamped;
  std::vector<std::pair<std::int32_t, std::uint32_t>> heard;
  TestGraph graph;
  graph.faults("g: {kind: stamps, topic: stamped, parameters: {by: -1.5}}")
      .add({.name = "source"},
           [](bw::Setup& setup) {
             setup.every(Duration::milliseconds(10), "tick",
                         [out = setup.output<Stamped>("stamped")](const Tick&) mutable {
                           Stamped message;
                           message.header().stamp().sec(10);
                           message.header().stamp().nanosec(250'000'000);
                           out.publish(message);
                         });
           })
      .add({.name = "sink"}, [&](bw::Setup& setup) {
        setup.input<Stamped>("stamped", Qos::standard(), [&](const auto& m, const Tick&) {
          heard.emplace_back(m.header().stamp().sec(), m.header().stamp().nanosec());
        });
      });
  graph.run(0.01);
  EXPECT_THAT(heard, ElementsAre(std::pair(8, 750'000'000U)));
}

// The component sees another time, and its timers come when they did.
TEST(Faults, SetTheClockOfOneComponent) {
  std::vector<std::int64_t> wrong, right;
  const auto watches = [](std::vector<std::int64_t>& seen) {
    return [&seen](bw::Setup& setup) {
      setup.every(Duration::milliseconds(10), "tick",
                  [&seen](const Tick& tick) { seen.push_back(ms(tick.now)); });
    };
  };
  TestGraph graph;
  graph.faults("f: {kind: clock_step, of: wrong, from: 20ms, for: 20ms, parameters: {by: -3600}}")
      .add({.name = "wrong"}, watches(wrong))
      .add({.name = "right"}, watches(right));
  graph.run(0.05);
  EXPECT_THAT(wrong, ElementsAre(10, 20 - 3'600'000, 30 - 3'600'000, 40, 50));
  EXPECT_THAT(right, ElementsAre(10, 20, 30, 40, 50));
}

TEST(Faults, LetAClockRunFast) {
  std::vector<std::int64_t> seen;
  TestGraph graph;
  graph.faults("f: {kind: clock_rate, of: process1, from: 10ms, parameters: {ppm: 500000}}")
      .add({.name = "fast", .process = "process1"}, [&](bw::Setup& setup) {
        setup.every(Duration::milliseconds(20), "tick",
                    [&](const Tick& tick) { seen.push_back(ms(tick.now)); });
      });
  graph.run(0.06);
  EXPECT_THAT(seen, ElementsAre(20 + 5, 40 + 15, 60 + 25));
}

// Ages of inputs are by the component's own clock: after a step of an hour all is old until it is heard again.
TEST(Faults, AClockThatIsSetMakesInputsOldOnce) {
  std::vector<Health> seen;
  TestGraph graph;
  ComponentNode user{.name = "user"};
  user.inputs = {{.name = "a", .max_age = Duration::milliseconds(15), .where = {}}};
  graph.faults("f: {kind: clock_step, of: user, from: 15ms}")
      .add({.name = "source"}, ticker("a", 10))
      .add(std::move(user), [&](bw::Setup& setup) {
        setup.input<Float64>("a", Qos::standard(), [](const auto&, const Tick&) {});
        setup.every(Duration::milliseconds(8), "tick",
                    [&](const Tick& tick) { seen.push_back(tick.health); });
      });
  graph.run(0.04);  // 8, 16 (old), 24, 32, 40 ms
  EXPECT_THAT(seen, ElementsAre(Health::ok, Health::stop, Health::ok, Health::ok, Health::ok));
}

struct Speed {
  double limit = 1.0;
  template <class Visitor>
  void fields(Visitor& v) {
    v("limit", limit, {.unit = "m/s", .min = 0, .max = 5, .doc = "a test's"});
  }
};

std::function<void(Setup&)> has_a_limit(std::vector<double>* seen) {
  return [seen](bw::Setup& setup) {
    setup.parameters<Speed>([seen](const Speed& now, const Tick&) {
      if (seen != nullptr) seen->push_back(now.limit);
    });
  };
}

TEST(Faults, ChangeParametersAndGiveThemBack) {
  std::vector<double> seen;
  TestGraph graph;
  graph.faults("f: {kind: parameters, of: base, from: 20ms, for: 10ms, every: 30ms, parameters: {limit: 3}}")
      .add({.name = "base"}, has_a_limit(&seen));
  graph.run(0.065);
  EXPECT_THAT(seen, ElementsAre(3.0, 1.0, 3.0, 1.0));
}

TEST(Faults, AreToldWhenTheyBeginAndEnd) {
  std::vector<std::string> told, shown;
  TestGraph graph;
  graph.faults("blind: {kind: lost, topic: a, from: 995ms, for: 1s}")
      .add({.name = "source"}, ticker("a", 10))
      .add({.name = "sink"}, [&](bw::Setup& setup) {
        setup.input<Float64>("a", Qos::standard(), [](const auto&, const Tick&) {});
        const auto tells = [&](const Array& m, const Tick& tick) {
          told.push_back(m.status().at(0).name() + "; " + m.status()[0].message() + "@" +
                         std::to_string(ms(tick.now)));
        };
        setup.input<Array>("/faults", Qos::standard(100), tells, Need::optional);
        const auto shows = [&](const Array& m, const Tick&) {
          for (const auto& status : m.status()) {
            if (status.name() == "faults")
              shown.push_back(status.message() + "; " + status.values().at(0).value());
          }
        };
        setup.input<Array>("/diagnostics", Qos::standard(), shows, Need::optional);
      });
  graph.run(3.1);
  EXPECT_THAT(told, ElementsAre("blind; lost on /a@1000", "blind; lost on /a: over@2000"));
  EXPECT_THAT(shown, ElementsAre("no fault acts; lost on /a: to come", "on purpose: blind; lost on /a: acts",
                                 "no fault acts; lost on /a: over"));
}

TEST(Faults, AreTheSameWithTheSameSeed) {
  const auto run = [](std::uint64_t seed) {
    std::vector<std::string> heard;
    TestGraph graph;
    graph.faults("f: {kind: lost, topic: a, parameters: {share: 0.5}}")
        .add({.name = "source"}, ticker("a", 10))
        .add({.name = "sink"}, writes_down(heard));
    graph.run(1.0, seed);
    return heard;
  };
  EXPECT_EQ(run(1), run(1));
  EXPECT_NE(run(1), run(2));
  EXPECT_NEAR(static_cast<double>(run(1).size()), 50.0, 20.0);  // of 100; 4 standard deviations
}

// As a replay does: what it says has had its faults already.
TEST(Faults, LeaveAloneWhatAProgramAddsToTheGraph) {
  std::vector<std::string> heard;
  TestGraph graph;
  graph.faults("f: {kind: lost, topic: a}").add({.name = "sink"}, writes_down(heard));
  std::vector<ExtraComponent> player;
  player.push_back(
      {.name = "player", .component = std::make_unique<Scripted>(ticker("a", 10)), .first = true});
  Host host(graph.graph(), {.clock = ClockMode::lockstep}, std::move(player));
  host.run(Duration::milliseconds(20));
  EXPECT_THAT(heard, ElementsAre("0@10", "1@20"));
}

TEST(Faults, ActInRealTimeToo) {
  std::atomic<int> lost = 0, whole = 0;
  TestGraph graph;
  graph.faults("f: {kind: lost, topic: a}")
      .add({.name = "source"}, ticker("a", 10))
      .add({.name = "other"}, ticker("b", 10))
      .add({.name = "sink"}, [&](bw::Setup& setup) {
        setup.input<Float64>("a", Qos::standard(), [&](const auto&, const Tick&) { ++lost; });
        setup.input<Float64>("b", Qos::standard(), [&, end = setup.finish_run()](const auto&, const Tick&) {
          if (++whole == 10) end(true, "enough");
        });
      });
  Host host(graph.graph(), {.clock = ClockMode::wall});
  EXPECT_TRUE(host.run(Duration::seconds(20.0)).ok);
  EXPECT_EQ(lost, 0);
  EXPECT_GE(whole, 10);
}

std::string refusal_of(const std::string& faults, ClockMode clock = ClockMode::lockstep) {
  TestGraph graph;
  graph.faults(faults).add({.name = "source"}, ticker("a", 10)).add({.name = "base"}, has_a_limit(nullptr));
  try {
    Host host(graph.graph(), {.clock = clock});
    host.run(Duration::milliseconds(10));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Faults, AreRefusedWithFileLineKeyValueAndRule) {
  EXPECT_EQ(refusal_of("f: {kind: lots, topic: a}"),
            "g.yaml:1: faults.f.kind = lots: unknown kind of fault; did you mean 'lost'?");
  EXPECT_THAT(refusal_of("f: {kind: lost, topic: aa}"),
              HasSubstr("g.yaml:1: faults.f.topic = /aa: must be published in the graph: unknown topic"));
  EXPECT_EQ(refusal_of("f: {kind: lost}"), "g.yaml:1: faults.f.topic: must be given: this kind is of any");
  EXPECT_EQ(refusal_of("f: {kind: lost, topic: a, parameters: {share: 2}}"),
            "g.yaml:1: faults.f.parameters.share = 2: must be between 0 and 1");
  EXPECT_EQ(refusal_of("f: {kind: lost, topic: a, of: source}"),
            "g.yaml:1: faults.f.of = source: must not be given: this kind is of a topic");
  EXPECT_EQ(
      refusal_of("f: {kind: stamps, topic: a}"),
      "g.yaml:1: faults.f.topic = /a: must carry a type that begins with std_msgs/msg/Header, and carries "
      "std_msgs/msg/Float64");
  EXPECT_EQ(refusal_of("doubled: {topic: /rosout}"),
            "g.yaml:1: faults.doubled.topic = /rosout: must carry std_msgs/msg/Float64, and carries "
            "rcl_interfaces/msg/Log");
  EXPECT_EQ(refusal_of("f: {kind: clock_step}"), "g.yaml:1: faults.f.of: must name a component or a process");
  EXPECT_THAT(refusal_of("f: {kind: clock_step, of: sources}"), HasSubstr("did you mean 'source'?"));
  EXPECT_EQ(refusal_of("f: {kind: parameters, of: base, parameters: {limits: 3}}"),
            "g.yaml:1: faults.f.parameters.limits = 3: unknown parameter of base; did you mean 'limit'?");
  EXPECT_THAT(refusal_of("f: {kind: parameters, of: base, parameters: {limit: 9}}"),
              HasSubstr("faults.f.parameters.limit = 9: "));
  EXPECT_EQ(
      refusal_of("f: {kind: process_killed, of: main}"),
      "g.yaml:1: faults.f.kind = process_killed: is of a process, which lock-step has not: `bandwagon launch`");
  EXPECT_EQ(
      refusal_of("f: {kind: process_killed, of: main}", ClockMode::wall),
      "g.yaml:1: faults.f.kind = process_killed: needs `bandwagon launch`: nobody else would start the process "
      "again");
}

}  // namespace
}  // namespace bw
