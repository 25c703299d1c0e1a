// The robots of config/robots/ against the figures of model/README.md 2.3.
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "components/model/robot.hpp"
#include "runtime/parameters/read_parameters.hpp"
#include "runtime/parameters/write_parameters.hpp"
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

Robot robot_of(const std::string& yaml) {
  Robot values;
  read_into(values, parse_yaml(yaml, "robot.yaml"), "robot");
  return values;
}

TEST(RobotFiles, TheFootprintIsATextOrAList) {
  const std::string corners = "[[0.255, 0.215], [-0.255, 0.215], [-0.255, -0.215], [0.255, -0.215]]";
  const Robot of_text = robot_of("footprint: '" + corners + "'\nradius: 0.2\n");
  const Robot of_list = robot_of(
      "footprint:\n  - [0.255, 0.215]\n  - [-0.255, 0.215]\n  - [-0.255, -0.215]\n  - [0.255, -0.215]\n");
  EXPECT_EQ(of_text.footprint, corners);
  EXPECT_EQ(of_list.outline().polygon, of_text.outline().polygon);
  EXPECT_EQ(of_text.outline().polygon.size(), 4U);
  EXPECT_NEAR(of_text.outline().radius, 0.33354, 1e-5) << "encloses it, whatever radius says";
  EXPECT_FALSE(robot_of("radius: 0.2").outline().is_polygon());
  EXPECT_EQ(robot_of("radius: 0.2").outline().radius, 0.2);
  // As it is read back from a run's manifest.
  Robot again;
  read_into(again, parse_yaml(to_yaml(of_list), "again.yaml"), "robot");
  EXPECT_EQ(again.outline().polygon, of_text.outline().polygon);
}

TEST(RobotFiles, AFootprintThatIsNoneIsRefusedWhereItStands) {
  const auto refusal = [](const std::string& yaml) -> std::string {
    try {
      robot_of(yaml);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(
      refusal("name: X\nfootprint: '[[0.2, 0.2], [-0.2, 0.2]]'\n"),
      "robot.yaml:2: robot.footprint = \"[[0.2, 0.2], [-0.2, 0.2]]\": must have three corners at least that are not "
      "on one line");
  EXPECT_EQ(refusal("footprint: [[0.5, 0.0], [-0.5, 0.4], [-0.2, 0.0], [-0.5, -0.4]]\n"),
            "robot.yaml:1: robot.footprint = a list: must be convex: the outline turns inwards at a corner");
  EXPECT_EQ(
      refusal("footprint: '[[1.5, 0.2], [1.1, 0.2], [1.1, -0.2]]'\n"),
      "robot.yaml:1: robot.footprint = \"[[1.5, 0.2], [1.1, 0.2], [1.1, -0.2]]\": must have base_link, [0, 0], inside "
      "and 1 mm from every side at least");
  EXPECT_NE(refusal("footprint: {x: 1}\n").find("robot.footprint = a map"), std::string::npos);
}

}  // namespace
}  // namespace bw
