// What /diagnostics tells of components, in lock-step.
#include <map>
#include <string>

#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <gtest/gtest.h>
#include <std_msgs/msg/float64.hpp>

#include "runtime/host/host.hpp"
#include "runtime/host/lockstep_runner.hpp"
#include "runtime/stamps.hpp"
#include "tests/runtime/scripted.hpp"

namespace bw {
namespace {

using diagnostic_msgs::msg::DiagnosticArray;
using std_msgs::msg::Float64;
using Values = std::map<std::string, std::string>;

/// Of component `worker`, by the full seconds since the start. It hears /a every 300 ms until 1.5 s, and
/// never /b.
std::map<int, Values> values_of_worker() {
  Graph graph;
  graph.components.push_back(scripted({.name = "source"}, [](bw::Setup& setup) {
    setup.every(Duration::milliseconds(300), "tick",
                [out = setup.output<Float64>("a")](const Tick& tick) mutable {
                  if (tick.sequence < 5) out.publish({});
                });
  }));
  graph.components.push_back(scripted(
      {.name = "worker",
       .process = "control",
       .lane = "fast",
       .latency = Duration::seconds(0.0025),
       .inputs = {{.name = "a", .max_age = Duration::milliseconds(800), .on_stale = OnStale::degrade},
                  {.name = "b", .external = true}}},
      [](bw::Setup& setup) {
        setup.diagnostics().set_value("mode", "test");
        setup.input<Float64>("a", Qos::standard(), [](const Float64&, const Tick&) {});
        setup.latest<Float64>("b", Qos::standard());
      }));
  std::map<int, Values> seen;
  graph.components.push_back(scripted({.name = "observer"}, [&seen](bw::Setup& setup) {
    const auto keep = [&seen](const DiagnosticArray& message, const Tick&) {
      const double t = (from_stamp(message.header().stamp()) - LockstepRunner::kStart).to_seconds();
      for (const auto& status : message.status()) {
        if (status.name() != "worker") continue;
        for (const auto& pair : status.values()) seen[static_cast<int>(t + 1e-6)][pair.key()] = pair.value();
      }
    };
    setup.input<DiagnosticArray>("/diagnostics", Qos::standard(), keep, Need::optional);
  }));
  Host host(graph, {.clock = ClockMode::lockstep});
  host.run(Duration::seconds(3.0));
  return seen;
}

// Samples at 0.3, 0.6, 0.9, 1.2, 1.5 s. At 1 s the last is 0.1 s old; from there to 2 s come two. At 3 s it
// is 1.5 s old, which is more than 800 ms. Nothing measured on a real clock is among it.
TEST(Diagnostics, TellPlaceAgesAndRates) {
  const auto seen = values_of_worker();
  ASSERT_GE(seen.size(), 3U);
  const Values location = {{"process", "control"}, {"lane", "fast"}, {"latency", "2.5 ms"}, {"mode", "test"}};
  const auto with = [&location](Values more) {
    more.insert(location.begin(), location.end());
    return more;
  };
  EXPECT_EQ(seen.at(1), with({{"age /a", "100.0 ms of 800 ms"}, {"age /b", "never"}}));
  EXPECT_EQ(seen.at(2), with({{"age /a", "500.0 ms of 800 ms"},
                              {"rate /a", "2.0 Hz"},
                              {"age /b", "never"},
                              {"rate /b", "0.0 Hz"}}));
  EXPECT_EQ(seen.at(3), with({{"age /a", "1500.0 ms of 800 ms"},
                              {"rate /a", "0.0 Hz"},
                              {"age /b", "never"},
                              {"rate /b", "0.0 Hz"},
                              {"a", "stale"}}));
}

// One that a component declares, in force from 1.5 s to 2.5 s, and one by its input's age: in the table both, among the values
// while it acts.
TEST(Diagnostics, TellWhichFailsafesAreInForce) {
  Graph graph;
  graph.components.push_back(scripted({.name = "source"}, [](bw::Setup& setup) {
    setup.every(Duration::milliseconds(100), "tick",
                [out = setup.output<Float64>("a")](const Tick&) mutable { out.publish({}); });
  }));
  graph.components.push_back(
      scripted({.name = "worker",
                .inputs = {{.name = "a", .max_age = Duration::milliseconds(800), .on_stale = OnStale::stop}}},
               [](bw::Setup& setup) {
                 setup.input<Float64>("a", Qos::standard(), [](const Float64&, const Tick&) {});
                 const Failsafe cold = setup.failsafe({.name = "cold",
                                                       .condition = "it freezes",
                                                       .debounce = Duration::milliseconds(500),
                                                       .action = FailsafeAction::slow,
                                                       .recovery = "by itself, in spring"});
                 setup.every(Duration::milliseconds(500), "look", [cold](const Tick& tick) {
                   const double t = (tick.now - LockstepRunner::kStart).to_seconds();
                   cold.set(t > 1.4 && t < 2.4);
                 });
               }));
  std::map<int, bool> in_force;
  graph.components.push_back(scripted({.name = "observer"}, [&](bw::Setup& setup) {
    setup.input<DiagnosticArray>(
        "/diagnostics", Qos::standard(),
        [&](const DiagnosticArray& message, const Tick&) {
          const double t = (from_stamp(message.header().stamp()) - LockstepRunner::kStart).to_seconds();
          for (const auto& status : message.status()) {
            for (const auto& pair : status.values()) {
              if (pair.key() == "failsafe cold")
                in_force[static_cast<int>(t + 1e-6)] = pair.value() == "slow";
            }
          }
        },
        Need::optional);
  }));
  Host host(graph, {.clock = ClockMode::lockstep});
  const auto table = host.failsafes();
  ASSERT_EQ(table.size(), 2U);
  EXPECT_EQ(table[0].second.name, "cold");
  EXPECT_EQ(table[1].second.name, "a");
  EXPECT_EQ(table[1].second.debounce, Duration::milliseconds(800));
  EXPECT_EQ(table[1].second.action, FailsafeAction::stop);
  host.run(Duration::seconds(3.5));
  EXPECT_EQ(in_force, (std::map<int, bool>{{2, true}}));
}

}  // namespace
}  // namespace bw
