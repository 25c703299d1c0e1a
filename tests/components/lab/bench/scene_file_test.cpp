#include "components/lab/bench/scene_file.hpp"

#include <cstdio>
#include <fstream>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bw {
namespace {

const char* const kGood = R"(version: 1
replan_period: 0.1
warm_cycles: 2
limits: {v_max: 0.4, v_back_max: 0.2, omega_max: 0.3, acc_max: 0.5, alpha_max: 0.5}
band: {dt_ref: 0.3, dt_hysteresis: 0.1, min_samples: 3, max_samples: 500, inner_iterations: 5, outer_iterations: 4}
obstacles_cfg: {min_dist: 0.5, inflation_dist: 0.6, dynamic_inflation_dist: 0.6}
weights: {max_vel_x: 2, max_vel_theta: 1, acc_lim_x: 1, acc_lim_theta: 1, kinematics_nh: 1000, forward_drive: 1, time: 1, obstacle: 50, inflation: 0.1, dynamic_obstacle: 50, dynamic_inflation: 0.1, penalty_epsilon: 0.05}
scenes:
  - name: one
    start: {x: 0, y: 0, theta: 0}
    goal: {x: 3, y: 0, theta: 0}
    obstacles:
      - {x: 1.2, y: 0.42, r: 0.1, vx: 0.5, vy: 0}
)";

std::string write(const std::string& text) {
  std::string path = ::testing::TempDir() + "scene_file_test.yaml";
  std::ofstream(path) << text;
  return path;
}

std::string error_of(const std::string& text) {
  try {
    read_scene_file(write(text));
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = kGood;
  return text.replace(text.find(from), from.size(), to);
}

TEST(SceneFile, ReadsItsNumbers) {
  const SceneFile file = read_scene_file(write(kGood));
  ASSERT_EQ(file.scenes.size(), 1U);
  EXPECT_EQ(file.scenes[0].name, "one");
  EXPECT_EQ(file.limits.v_max, 0.4);
  EXPECT_EQ(file.weights.kinematics_nh, 1000);
  EXPECT_TRUE(file.scenes[0].obstacles[0].moves());
  EXPECT_FALSE(file.closed_loop.has_value());
}

TEST(SceneFile, NamesFileLineKeyAndRule) {
  using ::testing::AllOf;
  using ::testing::HasSubstr;
  EXPECT_THAT(error_of(replaced("v_max: 0.4", "v_max: -1")),
              AllOf(HasSubstr(".yaml:4:"), HasSubstr("v_max"), HasSubstr("0.01")));
  EXPECT_THAT(error_of(replaced("v_max: 0.4", "v_max: .nan")), HasSubstr("v_max"));
  EXPECT_THAT(error_of(replaced("v_max: 0.4", "v_max: fast")), HasSubstr("must be a number"));
  EXPECT_THAT(error_of(replaced("v_max: 0.4", "vmax: 0.4")), HasSubstr("vmax is not a known key"));
  EXPECT_THAT(error_of(replaced("warm_cycles: 2\n", "")), HasSubstr("warm_cycles is missing"));
  EXPECT_THAT(error_of(replaced("warm_cycles: 2", "warm_cycles: 2.5")), HasSubstr("whole number"));
  EXPECT_THAT(error_of(replaced("r: 0.1", "r: -0.1")), HasSubstr("r = -0.1"));
  EXPECT_THAT(error_of("scenes: [}"), HasSubstr(".yaml:1:"));
  EXPECT_THAT(error_of("[]"), HasSubstr("must be a mapping"));
  EXPECT_THROW(read_scene_file("/nonexistent.yaml"), std::runtime_error);
}

}  // namespace
}  // namespace bw
