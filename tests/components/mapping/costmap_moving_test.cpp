// A sweep that takes its time, seen by a robot that rotates: the wall is one, and straight.
#include <gtest/gtest.h>

#include "components/mapping/costmap/local_grid.hpp"
#include "components/model/sweep_motion.hpp"
#include "tests/components/model/moving_sweep.hpp"

namespace bw::costmap {
namespace {

struct Marked {
  int on_wall = 0;
  int off_wall = 0;
};

// Cells whose centre is within one cell's edge of the wall at x = 2.525, in the middle of its column.
Marked marked(bool each_from_its_pose) {
  test::MovingSweep moving{.twist = {0.3, 1.9}, .X_BL = {}, .wall = 2.525};
  LaserSweep sweep = moving.scan();
  std::vector<Pose2> poses;
  if (each_from_its_pose) poses = beam_poses(sweep, {}, [&](Time time) { return moving.X_OB(time); });
  sweep.beam_poses = poses;
  LocalGrid grid({});
  for (int i = 0; i < 3; ++i) {
    sweep.time = moving.time + Duration::milliseconds(143 * i);
    EXPECT_EQ(grid.add(sweep, {}, {0.2, {}}, {}), SweepFault::none);
  }
  Marked cells;
  for (int row = 0; row < grid.cells().height; ++row) {
    for (int column = 0; column < grid.cells().width; ++column) {
      if (grid.cells().at(column, row) != OccupancyGrid::kOccupied) continue;
      const bool is_on_wall = std::abs(grid.cells().center(column, row).x() - 2.525) < 0.03;
      ++(is_on_wall ? cells.on_wall : cells.off_wall);
    }
  }
  return cells;
}

// Marked up to 5 m: 2 * sqrt(5^2 - 2.525^2) = 8.63 m of wall in cells of 0.05 m. At its ends, a sixth of a
// turn from the middle, 24 ms of 1.9 rad/s, a sweep taken for one instant is 0.2 m off.
TEST(LocalGridMoving, AWallIsStraightFromARobotThatTurns) {
  const Marked placed = marked(true);
  EXPECT_NEAR(placed.on_wall, 8.63 / 0.05, 3);
  EXPECT_EQ(placed.off_wall, 0);
  const Marked as_one = marked(false);
  EXPECT_GT(as_one.off_wall, 50);
}

}  // namespace
}  // namespace bw::costmap
