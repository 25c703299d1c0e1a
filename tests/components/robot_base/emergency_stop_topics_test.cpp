// The emergency stop of robot_base on its topics: through every state of the component in lock-step, and over
// a restart in real time, pressed by writers that keep their samples and by some that do not.
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <bandwagon_msgs/msg/base_state.hpp>
#include <gmock/gmock.h>
#include <lifecycle_msgs/srv/change_state.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_srvs/srv/trigger.hpp>

#include "components/robot_base/adaptor/emergency_stop_file.hpp"
#include "runtime/parameters/yaml_file.hpp"
#include "runtime/ros/service_call.hpp"
#include "runtime/ros/typed_topic.hpp"
#include "tests/components/component_rig.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/interop/process.hpp"

namespace bw {
namespace {

using bandwagon_msgs::msg::BaseState;
using lifecycle_msgs::srv::ChangeState;
using std_msgs::msg::Bool;
using std_srvs::srv::Trigger;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
namespace state = bandwagon_msgs::msg::BaseState_Constants;

Bool pressed(bool is_pressed) {
  Bool message;
  message.data(is_pressed);
  return message;
}

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

TEST(EmergencyStopFile, GivesBackWhatItWasGiven) {
  EmergencyStop::Record record{.cause = "pressed by \"x\": # 'y'\n- {", .pressed = {}};
  for (int i = 0; i < 100; ++i) {
    EmergencyStop::Pressed button{.node = "/n" + std::to_string(i),
                                  .since = Time{1'700'000'000'123'456'789 + i}};
    for (std::size_t k = 0; k < button.writer.size(); ++k)
      button.writer[k] = static_cast<std::uint8_t>(17 * k + static_cast<std::size_t>(i));
    record.pressed.push_back(button);
  }
  EXPECT_EQ(record_of(parse_yaml(text_of(record), "x")), record);
}

/// robot_base in real time beside writers of other participants: what a process does with the folder of the
/// user's state.
class EmergencyStopRestart : public testing::Test {
 protected:
  using Buttons = TopicWriter<Bool>;

  void SetUp() override { std::filesystem::remove_all(folder_); }
  void TearDown() override { stop(); }

  void start() {
    const auto path = scratch_file("restart");
    std::ofstream(path)
        << "robot: {base: {driver: simulated}}\ncomponents: {robot_base: {inputs: {wheel_commands: {external: "
           "true}, sim/wheel_ticks: {external: true}}}}";
    host_ = std::make_unique<Host>(load_graph(path, {}), HostOptions{.clock = ClockMode::wall});
    thread_ = std::thread([this] { host_->run(std::nullopt); });
  }
  void stop() {
    if (!host_) return;
    // It may just have begun.
    test::eventually([&] { return state().has_value(); });
    host_->finish({}, true);
    thread_.join();
    host_.reset();
    states_.take_newest();
  }
  std::optional<BaseState> state() { return states_.take_newest(); }
  /// Until base_state has this reason, or for long enough.
  bool says(const testing::Matcher<std::string>& reason) {
    std::string last;
    return test::eventually([&] {
      if (const auto now = state()) last = now->reason();
      return reason.Matches(last);
    });
  }
  std::string release() {
    ServiceCaller caller(participant_, "/release_stop", service_type<Trigger>(), [] {});
    Trigger::Response response;
    if (!test::eventually([&] { return caller.is_ready(); })) return "nobody offers it";
    std::vector<std::uint8_t> request;
    serialize(Trigger::Request{}, request);
    const auto asked = caller.send(request);
    const bool has_answer = test::eventually([&] {
      const auto reply = caller.take(*asked);
      return reply && deserialize(*reply, response);
    });
    if (!has_answer) return "no answer";
    return (response.success() ? "yes: " : "no: ") + response.message();
  }
  static bool press(Buttons& button) {
    if (!test::eventually([&] { return button.readers() > 0; })) return false;
    button.publish(pressed(true));
    return button.flush(Duration::milliseconds(5000));
  }
  bool has_file() const {
    std::error_code ignored;
    return std::filesystem::exists(file_, ignored);
  }

  const std::filesystem::path folder_ = std::filesystem::path(std::getenv("XDG_STATE_HOME")) / "bandwagon";
  const std::filesystem::path file_ = folder_ / (std::string("domain_") + std::getenv("ROS_DOMAIN_ID")) /
                                      "robot_base" / "emergency_stop.yaml";
  dds::Participant participant_{{.network = dds::Network::from_environment(dds::Transport::localhost)}};
  TopicReader<BaseState> states_{participant_, "/base_state"};
  std::unique_ptr<Host> host_;
  std::thread thread_;
};

TEST_F(EmergencyStopRestart, AnotherProcessKnowsOfAButtonThatIsStillDown) {
  Buttons button(participant_, "/emergency_stop", Qos::standard());  // volatile: it does not say it again
  start();
  ASSERT_TRUE(press(button));
  ASSERT_TRUE(says(HasSubstr("is pressed by somebody")));
  ASSERT_TRUE(test::eventually([&] { return has_file(); }));
  // Set just after the file has its name, in a folder that is the owner's alone.
  EXPECT_TRUE(test::eventually([&] {
    return std::filesystem::status(file_).permissions() ==
           (std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  }));
  stop();
  EXPECT_TRUE(has_file());
  start();
  ASSERT_TRUE(says(HasSubstr("is pressed by somebody")));
  EXPECT_THAT(release(), StartsWith("no: the emergency stop is pressed by somebody"));
  ASSERT_TRUE(test::eventually([&] { return button.readers() > 0; }));
  button.publish(pressed(false));
  ASSERT_TRUE(says(HasSubstr("was pressed by somebody")));
  EXPECT_THAT(release(), StartsWith("yes: released"));
  ASSERT_TRUE(test::eventually([&] { return !has_file(); }));
  stop();
  start();
  EXPECT_TRUE(says(testing::Eq("")));
}

TEST_F(EmergencyStopRestart, WhoPressedAndLeftDoesNotRefuseTheRelease) {
  for (const Qos& qos : {Qos::standard(), Qos::latched()}) {
    start();
    {
      dds::Participant other{{.network = dds::Network::from_environment(dds::Transport::localhost)}};
      Buttons button(other, "/emergency_stop", qos);
      ASSERT_TRUE(press(button));
      ASSERT_TRUE(says(HasSubstr("is pressed by")));
      EXPECT_THAT(release(), StartsWith("no: "));
    }
    std::string answer;
    EXPECT_TRUE(test::eventually([&] { return (answer = release()).starts_with("yes"); })) << answer;
    EXPECT_THAT(answer, HasSubstr("pressed the emergency stop and has left"));
    stop();
  }
}

// It says nothing when it goes: until its lease is over, 4 s for a participant of this project, the answer
// names it and says for how long.
TEST_F(EmergencyStopRestart, WhoPressedAndWasKilledRefusesTheReleaseForItsLease) {
  test::Process button({PRESSED_BUTTON});
  start();
  ASSERT_TRUE(says(HasSubstr("is pressed by /panel")));
  const std::string refusal =
      "no: the emergency stop is pressed by /panel; one that was killed counts as there for 4 s after that";
  EXPECT_EQ(release(), refusal);
  button.signal(SIGKILL);
  std::string answer;
  EXPECT_TRUE(test::eventually([&] {
    answer = release();
    return answer != refusal;
  }));
  EXPECT_THAT(answer, testing::AllOf(StartsWith("yes: "),
                                     HasSubstr("/panel pressed the emergency stop and has left")));
}

TEST_F(EmergencyStopRestart, AButtonThatKeepsItsSampleIsHeardByWhoComesLater) {
  Buttons button(participant_, "/emergency_stop", Qos::latched());
  button.publish(pressed(true));
  start();
  EXPECT_TRUE(says(HasSubstr("is pressed by somebody")));
}

TEST_F(EmergencyStopRestart, OneThatIsNotReliableIsHeardToo) {
  Qos qos = Qos::standard();
  qos.reliability = Reliability::best_effort;
  Buttons button(participant_, "/emergency_stop", qos);
  start();
  EXPECT_TRUE(test::eventually([&] {
    button.publish(pressed(true));
    const auto now = state();
    return now && now->state() == state::EMERGENCY_STOP;
  }));
}

TEST_F(EmergencyStopRestart, LockStepNeitherReadsNorWrites) {
  EXPECT_EQ(run(1.0, {{0.5, "a", "press"}}).states.back().state(), state::EMERGENCY_STOP);
  EXPECT_FALSE(std::filesystem::exists(folder_));
  std::filesystem::create_directories(file_.parent_path());
  std::ofstream(file_) << "broken";
  EXPECT_NE(run(1.0, {}).states.back().state(), state::EMERGENCY_STOP);
  EXPECT_TRUE(has_file());
}

TEST_F(EmergencyStopRestart, WhatCannotBeReadIsLatchedAndSaysWhy) {
  const std::string good = text_of({.cause = "pressed", .pressed = {}});
  for (const std::string& text :
       {std::string(), std::string("{{{"), std::string("cause: ''\n"), std::string("cause: 3\nmore: 4\n"),
        std::string(3, '\0'), good.substr(0, good.size() / 2),
        "cause: x\npressed: [{writer: 12}]\n" + std::string()}) {
    std::filesystem::create_directories(file_.parent_path());
    std::ofstream(file_, std::ios::trunc) << text;
    start();
    EXPECT_TRUE(says(HasSubstr("cannot be read"))) << text;
    EXPECT_THAT(release(), StartsWith("yes: released")) << text;
    EXPECT_TRUE(test::eventually([&] { return !has_file(); })) << text;
    stop();
  }
  std::filesystem::create_directories(file_);  // a folder in its place
  start();
  EXPECT_TRUE(says(HasSubstr("cannot be read")));
}

}  // namespace
}  // namespace bw
