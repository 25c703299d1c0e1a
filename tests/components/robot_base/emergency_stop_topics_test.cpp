// The emergency stop of robot_base on its topics, through every state of the component in lock-step.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/base_state.hpp>
#include <gmock/gmock.h>
#include <lifecycle_msgs/srv/change_state.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_srvs/srv/trigger.hpp>

#include "tests/components/component_rig.hpp"
#include "tests/components/robot_base/pressed.hpp"

namespace bw {
namespace {

using bandwagon_msgs::msg::BaseState;
using lifecycle_msgs::srv::ChangeState;
using std_msgs::msg::Bool;
using std_srvs::srv::Trigger;
using testing::HasSubstr;
using testing::StartsWith;
namespace state = bandwagon_msgs::msg::BaseState_Constants;

/// What somebody does at a time of the run [s].
struct Deed {
  double seconds;
  std::string who;   ///< of "a" and "b"
  std::string what;  ///< press, lift, release, or a transition of robot_base
};

struct Seen {
  std::vector<std::string> answers;  ///< to releases
  std::vector<BaseState> states;

  const BaseState& at(double t) const {
    const BaseState* last = &states.front();
    for (const BaseState& one : states) {
      if (seconds_since_start(from_stamp(one.header().stamp())) <= t + 1e-9) last = &one;
    }
    return *last;
  }
};

const std::map<std::string, std::uint8_t> kTransitions = {
    {"configure", 1}, {"cleanup", 2}, {"activate", 3}, {"deactivate", 4}};

/// Nodes /a and /b, each with a button of its own, around robot_base in lock-step.
Seen run(double seconds, const std::vector<Deed>& deeds, const Qos& qos = Qos::standard(),
         const std::string& parameters = "") {
  Seen seen;
  const auto person = [&](const std::string& name) {
    return [&, name](Setup& setup) {
      const auto stop = setup.output<Bool>("emergency_stop", qos);
      const auto release = setup.client<Trigger>("release_stop");
      const auto change = setup.client<ChangeState>("robot_base/change_state");
      if (name == "a")
        setup.input<BaseState>("base_state", Qos::standard(50),
                               [&](const auto& m, const Tick&) { seen.states.push_back(m); });
      setup.every(
          Duration::milliseconds(10), "deeds", [&, name, stop, release, change](const Tick& tick) mutable {
            for (const Deed& deed : deeds) {
              if (deed.who != name || std::abs(seconds_since_start(tick.now) - deed.seconds) > 1e-6) continue;
              if (deed.what == "press" || deed.what == "lift") {
                stop.publish(pressed(deed.what == "press"));
              } else if (deed.what == "release") {
                release.call(
                    {}, Duration::milliseconds(500), [&](const Trigger::Response* response, const Tick&) {
                      seen.answers.push_back(response == nullptr ? "none"
                                                                 : (response->success() ? "yes: " : "no: ") +
                                                                       response->message());
                    });
              } else {
                ChangeState::Request request;
                request.transition().id(kTransitions.at(deed.what));
                change.call(request, Duration::milliseconds(500),
                            [](const ChangeState::Response* response, const Tick&) {
                              ASSERT_TRUE(response != nullptr && response->success());
                            });
              }
            }
          });
    };
  };
  const auto path = scratch_file("emergency_stop");
  std::ofstream(path)
      << "robot: {base: {driver: simulated}}\ncomponents: {robot_base: {inputs: {wheel_commands: {external: "
         "true}, sim/wheel_ticks: {external: true}}, parameters: {" +
             parameters + "}}}";
  std::vector<ExtraComponent> extra;
  for (const std::string name : {"a", "b"}) extra.push_back({name, std::make_unique<Script>(person(name))});
  Host host(load_graph(path, {}), {.clock = ClockMode::lockstep}, std::move(extra));
  host.run(Duration::seconds(seconds));
  std::filesystem::remove(path);
  return seen;
}

TEST(EmergencyStopTopics, AFalseLiftsOnesOwnButtonAndAReleaseNamesTheOther) {
  for (const Qos& qos : {Qos::standard(), Qos::latched()}) {
    const Seen seen = run(3.0,
                          {{0.3, "b", "lift"},  // first of all, and of no one
                           {0.5, "a", "press"},
                           {0.6, "b", "press"},
                           {0.7, "a", "lift"},
                           {1.0, "a", "release"},
                           {1.5, "b", "lift"},
                           {2.0, "a", "release"}},
                          qos);
    EXPECT_NE(seen.at(0.49).state(), state::EMERGENCY_STOP);
    EXPECT_EQ(seen.at(0.5).state(), state::EMERGENCY_STOP);  // at the instant it came
    EXPECT_EQ(seen.at(0.5).reason(), "the emergency stop is pressed by /a");
    EXPECT_EQ(seen.at(0.6).reason(), "the emergency stop is pressed by /a, /b");
    EXPECT_EQ(seen.at(1.9).reason(), "the emergency stop was pressed by /b");
    EXPECT_TRUE(seen.at(1.9).is_latched());
    EXPECT_THAT(seen.answers,
                testing::ElementsAre("no: the emergency stop is pressed by /b", StartsWith("yes: released")));
    EXPECT_NE(seen.states.back().state(), state::EMERGENCY_STOP);
  }
}

// The transitions take no time; base_state is told at 10 Hz while it is active.
TEST(EmergencyStopTopics, ItHoldsThroughEveryStateOfTheComponent) {
  const std::vector<Deed> down = {{0.5, "b", "deactivate"}, {0.6, "b", "cleanup"}};
  const std::vector<Deed> up = {{1.0, "b", "configure"}, {1.1, "b", "activate"}};
  for (const double when :
       {0.4, 0.55, 0.65, 1.05, 1.2}) {  // active, inactive, unconfigured, inactive, active
    std::vector<Deed> deeds = {
        {when, "a", "press"}, {2.0, "b", "release"}, {2.1, "a", "lift"}, {2.5, "b", "release"}};
    for (const auto& more : {down, up}) deeds.insert(deeds.end(), more.begin(), more.end());
    const Seen seen = run(3.0, deeds);
    EXPECT_EQ(seen.at(1.9).state(), state::EMERGENCY_STOP) << when;
    EXPECT_EQ(seen.at(1.9).reason(), "the emergency stop is pressed by /a") << when;
    EXPECT_THAT(seen.answers,
                testing::ElementsAre("no: the emergency stop is pressed by /a", StartsWith("yes: released")))
        << when;
    EXPECT_NE(seen.states.back().state(), state::EMERGENCY_STOP) << when;
  }
}

TEST(EmergencyStopTopics, LiftedWhileNobodyIsActiveItIsLatchedAllTheSame) {
  const Seen seen = run(3.0, {{0.4, "a", "press"},
                              {0.5, "b", "deactivate"},
                              {0.6, "a", "lift"},
                              {0.7, "b", "release"},
                              {1.0, "b", "activate"},
                              {2.0, "b", "release"}});
  EXPECT_EQ(seen.at(1.9).state(), state::EMERGENCY_STOP);
  EXPECT_EQ(seen.at(1.9).reason(), "the emergency stop was pressed by /a");
  EXPECT_THAT(seen.answers, testing::ElementsAre(HasSubstr("is not active"), StartsWith("yes: released")));
}

// 1,000 presses and as many lifts, 100 a second each.
TEST(EmergencyStopTopics, AThousandPressesAreOneStop) {
  std::vector<Deed> deeds;
  for (int i = 0; i < 1000; ++i) {
    deeds.push_back({0.5 + 0.01 * i, "a", "press"});
    deeds.push_back({0.5 + 0.01 * i, "b", i % 2 == 0 ? "press" : "lift"});
  }
  deeds.push_back({11.0, "b", "release"});
  deeds.push_back({11.5, "a", "lift"});
  deeds.push_back({12.0, "b", "release"});
  const Seen seen = run(13.0, deeds);
  for (const BaseState& one : seen.states) {
    const double t = seconds_since_start(from_stamp(one.header().stamp()));
    if (t > 0.5 && t < 12.0) {
      ASSERT_EQ(one.state(), state::EMERGENCY_STOP) << t;
    }
  }
  EXPECT_THAT(seen.answers,
              testing::ElementsAre("no: the emergency stop is pressed by /a", StartsWith("yes: released")));
  EXPECT_NE(seen.states.back().state(), state::EMERGENCY_STOP);
}

// A heartbeat of 0.1 s that ends at 1.0 s: a stop within 0.2 s and the 10 ms of a look.
TEST(EmergencyStopTopics, AListedButtonThatFallsSilentIsAStop) {
  std::vector<Deed> deeds = {{2.0, "b", "release"}, {3.5, "b", "release"}};
  for (int i = 1; i <= 40; ++i) {
    if (i <= 10 || i >= 30) deeds.push_back({0.1 * i, "a", "lift"});
  }
  const Seen seen =
      run(4.0, deeds, Qos::standard(), "emergency_stop: {buttons: [{node: /a, heartbeat: 0.2}]}");
  EXPECT_NE(seen.at(1.2).state(), state::EMERGENCY_STOP);
  EXPECT_EQ(seen.at(1.22).state(), state::EMERGENCY_STOP);
  EXPECT_EQ(seen.at(1.22).reason(), "the emergency stop button /a is silent");
  EXPECT_EQ(seen.at(3.4).state(), state::EMERGENCY_STOP);
  EXPECT_THAT(seen.answers, testing::ElementsAre("no: the emergency stop button /a is silent",
                                                 StartsWith("yes: released")));
  EXPECT_NE(seen.states.back().state(), state::EMERGENCY_STOP);
}

TEST(EmergencyStopTopics, LockStepNeitherReadsNorWritesTheFile) {
  const auto folder = std::filesystem::path(std::getenv("XDG_STATE_HOME")) / "bandwagon";
  const auto file =
      folder / (std::string("domain_") + std::getenv("ROS_DOMAIN_ID")) / "robot_base" / "emergency_stop.yaml";
  std::filesystem::remove_all(folder);
  EXPECT_EQ(run(1.0, {{0.5, "a", "press"}}).states.back().state(), state::EMERGENCY_STOP);
  EXPECT_FALSE(std::filesystem::exists(folder));
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << "broken";
  EXPECT_NE(run(1.0, {}).states.back().state(), state::EMERGENCY_STOP);
  EXPECT_TRUE(std::filesystem::exists(file));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace bw
