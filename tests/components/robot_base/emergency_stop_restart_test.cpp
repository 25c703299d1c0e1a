// What robot_base remembers of an emergency stop over a restart, in real time: pressed by writers that keep their
// samples and by some that do not.
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>

#include <bandwagon_msgs/msg/base_state.hpp>
#include <gmock/gmock.h>
#include <std_msgs/msg/bool.hpp>
#include <std_srvs/srv/trigger.hpp>

#include "components/robot_base/adaptor/emergency_stop_file.hpp"
#include "runtime/parameters/yaml_file.hpp"
#include "runtime/ros/service_call.hpp"
#include "runtime/ros/typed_topic.hpp"
#include "tests/components/component_rig.hpp"
#include "tests/components/robot_base/pressed.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/interop/process.hpp"

namespace bw {
namespace {

using bandwagon_msgs::msg::BaseState;
using std_msgs::msg::Bool;
using std_srvs::srv::Trigger;
using testing::HasSubstr;
using testing::StartsWith;
namespace state = bandwagon_msgs::msg::BaseState_Constants;

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
