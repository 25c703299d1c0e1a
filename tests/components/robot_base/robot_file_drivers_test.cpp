// Each robot file with its driver, in lock-step, where the test is the base: the section is read as it
// stands, and nothing moves.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sensor_msgs/msg/joint_state.hpp>
#include <std_msgs/msg/u_int8_multi_array.hpp>

#include "components/messages/wheel_joints.hpp"
#include "runtime/parameters/config_error.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {
namespace {

using testing::Each;
using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

/// What robot_base of this robot writes within half a second to a base that says nothing, while it is told to
/// drive.
std::vector<Bytes> written(const std::string& robot, std::vector<std::string> overrides = {}) {
  const std::filesystem::path path = scratch_file("drivers_of_" + robot);
  std::ofstream(path) << "robot: " << BANDWAGON_SOURCE_DIR << "/config/robots/" << robot
                      << ".yaml\ncomponents: {robot_base: {}}\n";
  overrides.insert(overrides.begin(), "robot.base.port=emulator");
  std::vector<Bytes> all;
  std::vector<ExtraComponent> extra;
  extra.push_back(
      {"script", std::make_unique<Script>([&](Setup& setup) {
         setup.output<std_msgs::msg::UInt8MultiArray>("sim/base/from_device", Qos::standard(1000));
         setup.input<std_msgs::msg::UInt8MultiArray>(
             "sim/base/to_device", Qos::standard(1000),
             [&](const auto& message, const Tick&) { all.push_back(message.data()); });
         setup.every(
             Duration::milliseconds(20), "drive",
             [out = setup.command<sensor_msgs::msg::JointState>("wheel_commands")](const Tick&) mutable {
               out.publish(to_joint_state({0.2, 0.2}, {0.035, 0.035}, {}));
             });
       })});
  Host host(load_graph(path, overrides), {.clock = ClockMode::lockstep}, std::move(extra));
  host.run(Duration::seconds(0.5));
  std::filesystem::remove(path);
  return all;
}

TEST(RobotFileDrivers, AKobukiIsToldToStand) {
  const Bytes stop = {0xAA, 0x55, 0x06, 0x01, 0x04, 0x00, 0x00, 0x00, 0x00, 0x03};
  for (const char* robot : {"kobuki", "qbot2e"}) {
    const std::vector<Bytes> all = written(robot);
    EXPECT_GE(all.size(), 15U) << robot;  // each 30 ms
    EXPECT_THAT(all, Each(stop)) << robot;
  }
}

TEST(RobotFileDrivers, AnEddieIsToldToStop) {
  const std::string stop = "STOP 0\r";
  const std::vector<Bytes> all = written("eddie");
  EXPECT_GE(all.size(), 4U);  // the blind one, and one each 110 ms
  EXPECT_THAT(all, Each(Bytes(stop.begin(), stop.end())));
}

TEST(RobotFileDrivers, WhatADriverDoesNotKnowIsRefused) {
  try {
    written("kobuki", {"robot.base.silense=0.2"});
    FAIL() << "not refused";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("silence"));
  }
  try {
    written("eddie", {"robot.base.sonar_pins=[1, 0]"});
    FAIL() << "not refused";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("must ascend"));
  }
}

}  // namespace
}  // namespace bw
