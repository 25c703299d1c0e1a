// Band planners drive a rectangle of 0.51 x 0.43 m where its disc of 0.33 m does not fit.
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "components/local_planner/planner_registry.hpp"
#include "tests/components/local_planner/planner_drive.hpp"

namespace bw {
namespace {

Footprint rectangle() {
  return {.radius = std::hypot(0.255, 0.215),
          .polygon = {{-0.255, -0.215}, {0.255, -0.215}, {0.255, 0.215}, {-0.255, 0.215}}};
}

// The one path through a long wall, where the plan leads: 2 m between points, rotated around (4, 0), `width`
// [m] apart.
PlanningProblem passage(double width, double rotation) {
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.footprint = rectangle();
  const Pose2 middle{4.0, 0.0, rotation};
  for (const double side : {-0.5, 0.5}) {
    for (int i = -20; i <= 20; ++i)
      problem.obstacles.points.push_back(middle * Vector2(0.05 * i, side * width));
    problem.obstacles.segments.push_back(
        {middle * Vector2(0.0, side * width), middle * Vector2(0.0, 20.0 * side)});
  }
  problem.plan = {{0, 0, 0}, middle * Pose2{-1.5, 0, 0}, middle * Pose2{1.5, 0, 0}, {8, 0, 0}};
  return problem;
}

class ARectangle : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Planners, ARectangle, testing::Values("teb", "teb_homotopy", "pteb", "eteb"));

TEST_P(ARectangle, DrivesThroughAPassageThatItFits) {
  // 0.6 m leaves 8.5 cm at either side, 0.5 m leaves 3.5 cm, and its disc of 0.67 m less than nothing.
  for (const auto& [width, rotation] : {std::pair(0.6, 0.0), std::pair(0.6, 0.5), std::pair(0.5, 0.0)}) {
    const PlanningProblem problem = passage(width, rotation);
    const auto planner = make_planner(GetParam(), {});
    const Drive result = drive(*planner, problem, 250);
    const std::string where =
        GetParam() + ", width " + std::to_string(width) + ", turn " + std::to_string(rotation);
    EXPECT_TRUE(is_at_rest_at({8, 0, 0}, result)) << where << " ends at x " << result.poses.back().x;
    EXPECT_GT(result.smallest_gap, 0.0) << where;
    EXPECT_LE(result.smallest_gap, 0.5 * (width - 0.43)) << where;
  }
}

TEST_P(ARectangle, DrivesNotThroughOneThatIsTooNarrow) {
  const auto planner = make_planner(GetParam(), {});
  const Drive result = drive(*planner, passage(0.42, 0.0), 150);
  EXPECT_GT(result.smallest_gap, 0.0);
  EXPECT_LT(result.poses.back().x, 4.0);
}

TEST_P(ARectangle, AsADiscItStaysOutside) {
  PlanningProblem problem = passage(0.6, 0.0);
  problem.footprint.polygon.clear();
  const auto planner = make_planner(GetParam(), {});
  const Drive result = drive(*planner, problem, 150);
  EXPECT_GT(result.smallest_gap, 0.0);
  EXPECT_LT(result.poses.back().x, 3.0);
}

}  // namespace
}  // namespace bw
