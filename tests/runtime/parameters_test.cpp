// Parameter reading, listing and writing. Expected texts follow from the message form of config_error.hpp.
#include <gtest/gtest.h>

#include "components/model/robot.hpp"
#include "runtime/parameters/list_parameters.hpp"
#include "runtime/parameters/overrides.hpp"
#include "runtime/parameters/read_parameters.hpp"
#include "runtime/parameters/write_parameters.hpp"
#include "runtime/parameters/yaml_file.hpp"

namespace bw {
namespace {

TEST(Smoke, Robot) {
  Robot robot = read_parameters<Robot>(parse_yaml("radius: 1\nlimits: {v_max: 2}\n", "r.yaml"), "robot");
  EXPECT_EQ(robot.radius, 1.0);
  EXPECT_EQ(robot.limits.v_max, 2.0);
  EXPECT_EQ(list_parameters(robot, "robot").size(), 12U);
  std::cout << to_yaml(robot);
}

}  // namespace
}  // namespace bw
