// A behavior server that nobody asks changes no byte of what drives the robot: ten seconds of the hallway, in
// which it starts, sees the first people and evades them.
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <gtest/gtest.h>
#include <sensor_msgs/msg/joint_state.hpp>

#include "tests/components/component_rig.hpp"

namespace bw {
namespace {

using Samples = std::map<std::string, std::vector<std::vector<std::uint8_t>>>;

template <class M>
void keep(bw::Setup& setup, const std::string& topic, Samples& samples) {
  setup.input<M>(topic, Qos::standard(50), [&all = samples[topic]](const M& message, const Tick&) {
    serialize(message, all.emplace_back());
  });
}

Samples drive(const std::vector<std::string>& settings) {
  Samples samples;
  std::vector<ExtraComponent> extra;
  extra.push_back({"script", std::make_unique<Script>([&](bw::Setup& setup) {
                     keep<geometry_msgs::msg::Twist>(setup, "cmd_vel", samples);
                     keep<sensor_msgs::msg::JointState>(setup, "wheel_commands", samples);
                     keep<bandwagon_msgs::msg::GroundTruth>(setup, "sim/ground_truth", samples);
                   })});
  const std::filesystem::path graph =
      std::filesystem::path(BANDWAGON_SOURCE_DIR) / "config/graphs/hallway.yaml";
  Host host(load_graph(graph, settings), {.clock = ClockMode::lockstep, .seed = 7}, std::move(extra));
  host.run(Duration::seconds(10.0));
  return samples;
}

TEST(IdleBehaviorServer, ChangesNoByteOfCommandsAndTruth) {
  const Samples with = drive({});
  const Samples without = drive({"behavior_server.enabled=false"});
  for (const auto& [topic, samples] : with) {
    EXPECT_GT(samples.size(), 100U) << topic;
    EXPECT_EQ(samples, without.at(topic)) << topic;
  }
}

}  // namespace
}  // namespace bw
