#include "components/local_planner/mppi/local_path.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace bw::mppi {
namespace {

const PlanningProblem kNothing;

LocalPath path_of(const std::vector<Pose2>& plan, const Pose2& robot, double length) {
  return local_path(plan, robot, length, Costmap(kNothing, {}, 1.0, true));
}

// Along (0, 0), (1, 0), (1, 2) from the point nearest to (0.52, -0.3): every 0.05 m round the corner for 1 m.
TEST(LocalPath, BeginsBesideTheRobotAndHasItsLength) {
  const LocalPath path = path_of({{0, 0, 0}, {1, 0, 0}, {1, 2, 0}}, {0.52, -0.3, 0.0}, 1.0);
  ASSERT_EQ(path.size(), 21);
  for (Eigen::Index i = 0; i < 21; ++i) {
    const double s = 0.52 + 0.05 * static_cast<double>(i);
    EXPECT_NEAR(path.x[i], std::min(s, 1.0) - 0.52, 1e-12) << i;
    EXPECT_NEAR(path.y[i], std::max(s - 1.0, 0.0) + 0.3, 1e-12) << i;
  }
}

TEST(LocalPath, EndsAtTheGoal) {
  const LocalPath path = path_of({{0, 0, 0}, {0.12, 0, 0}}, {0, 0, 0}, 1.0);
  ASSERT_EQ(path.size(), 4);
  EXPECT_NEAR(path.x[2], 0.1, 1e-12);
  EXPECT_NEAR(path.x[3], 0.12, 1e-12);
  EXPECT_EQ(path_of({{0, 0, 0}, {0.1, 0, 0}}, {0, 0, 0}, 1.0).size(), 3);  // a point already
  EXPECT_EQ(path_of({{3, 0, 0}}, {0, 0, 0}, 1.0).size(), 1);
  EXPECT_EQ(path_of({{3, 0, 0}, {3, 0, 0}}, {0, 0, 0}, 1.0).size(), 1);
}

TEST(LocalPath, IsSeenFromTheRobot) {
  const Pose2 robot{4.0, 1.0, 2.5};
  const LocalPath path = path_of({robot * Pose2{0.0, 0.5, 0}, robot * Pose2{2.0, 0.5, 0}}, robot, 0.5);
  ASSERT_EQ(path.size(), 11);
  EXPECT_NEAR(path.x[10], 0.5, 1e-12);
  EXPECT_NEAR(path.y[10], 0.5, 1e-12);
}

// 400 points and no more, however long.
TEST(LocalPath, OfALongStretchIsLessDense) {
  const LocalPath path = path_of({{0, 0, 0}, {1e5, 0, 0}}, {0, 0, 0}, 4e4);
  EXPECT_NEAR(static_cast<double>(path.size()), 401.0, 1.0);
  EXPECT_NEAR(path.spacing, 100.0, 1e-9);
}

// A post at 1 m on the way takes the points within 0.3 m of it, by the cells of 0.05 m that they lie in: the
// robot's radius.
TEST(LocalPath, KnowsWhatIsTaken) {
  PlanningProblem problem;
  problem.obstacles.points = {{1.0, 0.0}};
  const LocalPath path =
      local_path({{0, 0, 0}, {2, 0, 0}}, {0.0, 0.0, 0.0}, 2.0, Costmap(problem, {}, 2.5, true));
  for (Eigen::Index i = 0; i < path.size(); ++i) {
    const double distance = std::abs(path.x[i] - 1.0);
    if (std::abs(distance - 0.3) < 0.026) continue;
    EXPECT_EQ(path.free[static_cast<std::size_t>(i)], distance > 0.3) << i;
  }
}

// Ends at 0.31 and 0.62 m are nearest to points 6 and 12; one far to the side is nearest to some point, too.
TEST(LocalPath, FurthestReachedIsThatOfAnyMotion) {
  const LocalPath path = path_of({{0, 0, 0}, {2, 0, 0}}, {0, 0, 0}, 1.7);
  Eigen::ArrayXd x(3), y(3);
  x << 0.31, 0.62, 0.4;
  y << 0.0, 0.1, 5.0;
  EXPECT_EQ(furthest_reached(path, x, y), 12);
  EXPECT_EQ(furthest_reached(path, x - 1.0, y), 0);
  EXPECT_EQ(furthest_reached(path, x + 9.0, y), path.size() - 1);
}

}  // namespace
}  // namespace bw::mppi
