// A graph with a simulated world does not start with the driver of a real base.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sensor_msgs/msg/joint_state.hpp>
#include <unistd.h>

#include "runtime/parameters/config_error.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {
namespace {

using testing::HasSubstr;

void run_world(const std::string& base) {
  run_with_script("robot:\n  base: " + base + "\ncomponents: {world: {}}\n", 0.1,
                  [](Setup& setup) { setup.command<sensor_msgs::msg::JointState>("sim/wheel_commands"); });
}

TEST(WorldBesideHardware, IsRefusedAndBothWaysOutAreSaid) {
  try {
    run_world("{driver: kobuki, port: /dev/kobuki}");
    FAIL() << "not refused";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("_" + std::to_string(getpid()) + ".yaml:2: robot.base"));
    EXPECT_THAT(error.what(), HasSubstr("driver kobuki at /dev/kobuki would move a real robot"));
    EXPECT_THAT(error.what(), HasSubstr("--emulate"));
    EXPECT_THAT(error.what(), HasSubstr("--set robot.base.driver=simulated"));
  }
}

TEST(WorldBesideHardware, SimulatedAndEmulatedBasesAreNone) {
  EXPECT_NO_THROW(run_world("{driver: simulated}"));
  EXPECT_NO_THROW(run_world("{driver: simulated, port: /dev/kobuki}"));
  EXPECT_NO_THROW(run_world("{driver: kobuki, port: emulator, baud: 115200}"));
}

}  // namespace
}  // namespace bw
