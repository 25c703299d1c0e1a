// The robots of config/robots/ against the figures of book 2.3.
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "components/model/robot.hpp"
#include "runtime/parameters/read_parameters.hpp"
#include "runtime/parameters/yaml_file.hpp"

namespace bw {
namespace {

Robot robot(const std::string& name) {
  Robot values;
  read_into(values, load_yaml(std::string(BANDWAGON_SOURCE_DIR) + "/config/robots/" + name + ".yaml"),
            "robot");
  return values;
}

double millimetres_per_tick(const Robot& r) {
  return 2e3 * std::numbers::pi * r.wheel_radius / static_cast<double>(r.ticks_per_revolution);
}

TEST(RobotFiles, GenericIsTheDefault) {
  const Robot file = robot("generic");
  const Robot defaults;
  EXPECT_EQ(file.name, defaults.name);
  EXPECT_EQ(file.wheel_radius, defaults.wheel_radius);
  EXPECT_EQ(file.wheel_separation, defaults.wheel_separation);
  EXPECT_EQ(file.ticks_per_revolution, defaults.ticks_per_revolution);
  EXPECT_EQ(file.wheel_speed_max, defaults.wheel_speed_max);
  EXPECT_EQ(file.radius, defaults.radius);
  EXPECT_EQ(file.limits.v_max, defaults.limits.v_max);
  EXPECT_EQ(file.limits.omega_max, defaults.limits.omega_max);
  EXPECT_EQ(file.limits.acc_max, defaults.limits.acc_max);
  EXPECT_EQ(file.limits.jerk_max, defaults.limits.jerk_max);
  EXPECT_EQ(file.limits.stop_deceleration, defaults.limits.stop_deceleration);
}

TEST(RobotFiles, EncodersHaveTheResolutionOfTheBook) {
  EXPECT_NEAR(millimetres_per_tick(robot("qbot2e")), 0.0853, 0.0001);
  EXPECT_NEAR(millimetres_per_tick(robot("kobuki")), 0.0853, 0.0001);
  EXPECT_NEAR(millimetres_per_tick(robot("eddie")), 3.32, 0.01);
}

TEST(RobotFiles, EveryRobotCanTurnAtTopSpeed) {
  for (const char* name : {"generic", "qbot2e", "kobuki", "eddie"}) {
    const Robot r = robot(name);
    EXPECT_GT(r.wheel_speed_max, r.limits.v_max) << name;
    EXPECT_GE(r.limits.stop_deceleration, r.limits.acc_max) << name;
  }
}

}  // namespace
}  // namespace bw
