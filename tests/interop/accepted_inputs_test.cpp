// A run in lock-step that takes 24 changes from another program: parameters, transitions, services, goals,
// limits, people. They are part of its record, and every component that runs again on the record says the
// same bytes.
#include <filesystem>
#include <fstream>
#include <memory>

#include <action_msgs/srv/cancel_goal.hpp>
#include <bandwagon_msgs/srv/add_person.hpp>
#include <bandwagon_msgs/srv/push_person.hpp>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <gmock/gmock.h>
#include <lifecycle_msgs/srv/change_state.hpp>
#include <nav2_msgs/action/navigate_to_pose.hpp>
#include <nav2_msgs/msg/speed_limit.hpp>
#include <nav2_msgs/srv/clear_entire_costmap.hpp>
#include <nlohmann/json.hpp>
#include <rcl_interfaces/srv/set_parameters.hpp>
#include <rcl_interfaces/srv/set_parameters_atomically.hpp>
#include <rosgraph_msgs/msg/clock.hpp>

#include "runtime/ros/dds_names.hpp"
#include "runtime/ros/service_call.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using action_msgs::srv::CancelGoal;
using bandwagon_msgs::srv::AddPerson;
using bandwagon_msgs::srv::PushPerson;
using lifecycle_msgs::srv::ChangeState;
using nav2_msgs::action::NavigateToPose;
using nav2_msgs::srv::ClearEntireCostmap;
using rcl_interfaces::srv::SetParameters;
using rcl_interfaces::srv::SetParametersAtomically;

const std::string kGraph = std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/hallway.yaml";
std::filesystem::path folder() { return std::filesystem::temp_directory_path() / "accepted_inputs"; }
constexpr std::chrono::seconds kLong{5};

template <class M>
dds::EndpointOptions topic(const std::string& name, const Qos& qos) {
  return {.topic = dds_topic(name),
          .type = std::string(MessageTraits<M>::dds_name),
          .qos = qos,
          .user_data = user_data_of(std::string(MessageTraits<M>::type_hash)),
          .heartbeat = dds::kPromptHeartbeat};
}

rcl_interfaces::msg::Parameter number(const std::string& name, double value) {
  rcl_interfaces::msg::Parameter parameter;
  parameter.name(name);
  parameter.value().type(3);  // PARAMETER_DOUBLE
  parameter.value().double_value(value);
  return parameter;
}

/// Another program, beside a run of the hallway.
class Operator {
 public:
  bool set(const std::string& node, const std::string& name, double value) {
    SetParameters::Request request;
    request.parameters({number(name, value)});
    const auto response = call_service<SetParameters>(participant_, node + "/set_parameters", request, kLong);
    return response && response->results().at(0).successful();
  }
  bool set_both(const std::string& node, const std::string& one, double its, const std::string& other,
                double others) {
    SetParametersAtomically::Request request;
    request.parameters({number(one, its), number(other, others)});
    const auto response = call_service<SetParametersAtomically>(
        participant_, node + "/set_parameters_atomically", request, kLong);
    return response && response->result().successful();
  }
  bool change(const std::string& node, const std::string& label) {
    ChangeState::Request request;
    request.transition().label(label);
    const auto response = call_service<ChangeState>(participant_, node + "/change_state", request, kLong);
    return response && response->success();
  }
  bool clear() {
    return call_service<ClearEntireCostmap>(participant_, "/local_costmap/clear_entirely_local_costmap", {},
                                            kLong)
        .has_value();
  }
  /// Somebody who walks from (x, y) against the robot. Nothing when the world does not answer.
  std::optional<AddPerson::Response> add_person(double x, double y) {
    AddPerson::Request request;
    request.position().x(x);
    request.position().y(y);
    request.velocity().x(-0.5);
    return call_service<AddPerson>(participant_, "/add_person", request, kLong);
  }
  bool push_person(std::uint32_t id) {
    PushPerson::Request request;
    request.id(id);
    request.velocity_change().y(0.5);
    const auto response = call_service<PushPerson>(participant_, "/push_person", request, kLong);
    return response && response->success();
  }
  bool limit(double speed) {
    nav2_msgs::msg::SpeedLimit message;
    message.speed_limit(speed);
    return publish(*limits_, message);
  }
  bool go_to(double x) {
    geometry_msgs::msg::PoseStamped message;
    message.header().frame_id("map");
    message.pose().position().x(x);
    message.pose().orientation().w(1.0);
    return publish(*goals_, message);
  }
  /// The same by the action.
  bool ask_to_go_to(double x) {
    NavigateToPose::SendGoal::Request request;
    request.goal_id().uuid({1});
    request.goal().pose().header().frame_id("map");
    request.goal().pose().pose().position().x(x);
    request.goal().pose().pose().orientation().w(1.0);
    const auto response = call_service<NavigateToPose::SendGoal>(
        participant_, "/navigate_to_pose/_action/send_goal", request, kLong);
    return response && response->accepted();
  }
  bool cancel_all() {
    const auto response =
        call_service<CancelGoal>(participant_, "/navigate_to_pose/_action/cancel_goal", {}, kLong);
    return response && response->goals_canceling().size() == 1;
  }
  /// Waits for this instant of the run [s since its beginning].
  bool wait_until(double seconds) {
    return eventually([&] {
      dds::Sample sample;
      rosgraph_msgs::msg::Clock clock;
      while (clock_->take(sample)) {
        if (!deserialize(sample.cdr, clock)) continue;
        const double now = clock.clock().sec() + 1e-9 * clock.clock().nanosec();
        now_ = now - 1000.0;  // where virtual time begins
      }
      return now_ >= seconds;
    });
  }

 private:
  template <class M>
  bool publish(dds::Writer& writer, const M& message) {
    std::vector<std::uint8_t> cdr;
    serialize(message, cdr);
    return eventually([&] { return writer.matched_readers() > 0; }) && writer.write(cdr) &&
           writer.wait_until_received(Duration::milliseconds(5000));
  }

  dds::Participant participant_{{.network = dds::Network::from_environment(dds::Transport::localhost)}};
  std::unique_ptr<dds::Writer> limits_ =
      participant_.create_writer(topic<nav2_msgs::msg::SpeedLimit>("/speed_limit", Qos::standard()));
  std::unique_ptr<dds::Writer> goals_ =
      participant_.create_writer(topic<geometry_msgs::msg::PoseStamped>("/goal_pose", Qos::standard()));
  std::unique_ptr<dds::Reader> clock_ =
      participant_.create_reader(topic<rosgraph_msgs::msg::Clock>("/clock", Qos::clock()), [] {});
  double now_ = 0.0;
};

TEST(AcceptedInputs, AReplayOfTheRecordSaysTheSameBytes) {
  std::filesystem::remove_all(folder());
  std::filesystem::create_directories(folder());
  Process run({BANDWAGON_PROGRAM, "run", kGraph, "--clock", "lockstep", "--seed", "7", "--pace", "2",
               "--accept-inputs", "--stay", "--for", "16", "--record", folder() / "drive", "--json",
               folder() / "card.json"});
  Operator hand;
  int changes = 0;
  const auto at = [&](double seconds, auto change) {
    EXPECT_TRUE(hand.wait_until(seconds)) << run.err();
    const bool is_taken = change();
    EXPECT_TRUE(is_taken) << "change " << changes;
    changes += is_taken ? 1 : 0;
  };
  for (int i = 0; i < 8; ++i) {
    at(3.5 + 0.5 * i,
       [&] { return hand.set("/local_planner", "teb.band.min_obstacle_dist", 0.25 + 0.01 * i); });
  }
  at(7.6, [&] { return hand.set_both("/navigator", "settle_time", 0.5, "xy_tolerance", 0.3); });
  at(7.8, [&] { return hand.set("/motor_control", "command_timeout", 0.3); });
  at(8.0, [&] { return hand.limit(0.5); });
  at(8.3, [&] { return hand.clear(); });
  std::uint32_t person = 0;
  at(8.4, [&] {
    const auto response = hand.add_person(18.0, -2.0);
    if (response) person = response->id();
    return response && response->success();
  });
  EXPECT_EQ(person, 9U);  // behind the hallway's eight
  at(8.6, [&] { return hand.change("/people", "deactivate"); });
  at(8.9, [&] { return hand.change("/people", "activate"); });
  at(9.2, [&] { return hand.push_person(person); });
  at(9.5, [&] { return hand.go_to(12.0); });
  at(10.0, [&] { return hand.limit(0.0); });
  at(10.5, [&] { return hand.change("/local_planner", "deactivate"); });
  at(11.0, [&] { return hand.change("/local_planner", "activate"); });
  at(11.2, [&] { return hand.ask_to_go_to(15.0); });
  at(11.7, [&] { return hand.cancel_all(); });
  at(12.0, [&] { return hand.go_to(19.0); });
  at(13.0, [&] { return hand.clear(); });
  EXPECT_EQ(changes, 24) << run.err();
  ASSERT_EQ(run.wait(std::chrono::seconds(60)), 0) << run.err();

  std::ifstream card(folder() / "card.json");
  EXPECT_EQ(nlohmann::json::parse(card)["inputs"], "outside");
  for (const char* component :
       {"world", "localization", "people", "local_costmap", "global_planner", "local_planner", "twist_mux",
        "collision_monitor", "motor_control", "navigator"}) {
    const Outcome replay = run_to_end({BANDWAGON_PROGRAM, "replay", folder() / "drive", "--graph", kGraph,
                                       "--clock", "lockstep", "--run", component},
                                      std::chrono::seconds(120));
    EXPECT_EQ(replay.status, 0) << component << ": " << replay.out << replay.err;
  }
  std::filesystem::remove_all(folder());
}

// Without --accept-inputs nobody comes: the answer says why, and the run says the bytes it says alone.
TEST(AcceptedInputs, WithoutThemNobodyJoins) {
  std::filesystem::create_directories(folder());
  const auto command = [](const char* card, const char* pace) {
    return std::vector<std::string>{
        BANDWAGON_PROGRAM, "run", kGraph,   "--clock", "lockstep", "--seed",       "7",
        "--for",           "6",   "--pace", pace,      "--json",   folder() / card};
  };
  const auto sha256 = [](const char* card) {
    std::ifstream in(folder() / card);
    return nlohmann::json::parse(in)["samples_sha256"].get<std::string>();
  };
  Process asked(command("asked.json", "2"));
  Operator hand;
  EXPECT_TRUE(hand.wait_until(1.0)) << asked.err();
  const auto response = hand.add_person(18.0, -2.0);
  ASSERT_TRUE(response.has_value()) << asked.err();
  EXPECT_FALSE(response->success());
  EXPECT_THAT(response->message(), testing::HasSubstr("--accept-inputs"));
  ASSERT_TRUE(asked.wait(std::chrono::seconds(60))) << asked.err();
  run_to_end(command("alone.json", "0"), std::chrono::seconds(60));
  EXPECT_EQ(sha256("asked.json"), sha256("alone.json"));
  std::filesystem::remove_all(folder());
}

}  // namespace
}  // namespace bw::test
