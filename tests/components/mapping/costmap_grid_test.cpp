#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "components/mapping/costmap/local_grid.hpp"
#include "components/model/nearest_point.hpp"
#include "components/model/random.hpp"
#include "components/world/ray.hpp"
#include "tests/components/mapping/costmap_oracle.hpp"

namespace bw::costmap {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

struct Sweep {
  std::vector<float> ranges;
  LaserSweep scan;

  /// `count` beams over `width` [rad] around the heading.
  Sweep(double seconds, const Pose2& X_OL, int count, double width, float value = kNaN)
      : ranges(static_cast<std::size_t>(count), value) {
    scan = {.time = Time::seconds(seconds),
            .X_FL = X_OL,
            .angle_min = -width / 2.0,
            .angle_increment = width / (count - 1),
            .range_min = 0.05,
            .range_max = 20.0,
            .ranges = ranges,
            .angle_max = width / 2.0};
  }

  void look_at(const std::vector<Segment>& walls, double noise = 0.0, std::uint64_t seed = 1) {
    Random random(seed);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      double range = kNoHit;
      const Vector2 unit =
          direction(scan.X_FL.theta + scan.angle_min + static_cast<double>(i) * scan.angle_increment);
      for (const Segment& wall : walls) range = std::min(range, ray_hit(scan.X_FL.position(), unit, wall));
      ranges[i] = static_cast<float>(range + noise * random.normal());
    }
  }
};

std::int8_t value_at(const LocalGrid& grid, const Vector2& p) {
  return grid.cells().at(grid.cells().column_of(p.x()), grid.cells().row_of(p.y()));
}

SweepFault add(LocalGrid& grid, const Sweep& sweep, const std::vector<Disc>& people = {}) {
  return grid.add(sweep.scan, sweep.scan.X_FL, {0.3, {}}, people);
}

// The rules of the header applied to every beam and every cell by slabs, over four sweeps from positions that
// move, with readings of every kind and people about: equal cell by cell.
TEST(LocalGrid, EqualsBruteForceOn200RandomMaps) {
  GridOptions options{.width = 2.4,
                      .height = 2.2,
                      .obstacle_min_range = 0.1,
                      .obstacle_max_range = 1.6,
                      .raytrace_max_range = 1.9,
                      .settled_hits = 2,
                      .young_time = 0.15,
                      .decay_time = 0.25};
  long occupied = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    options.hit_margin = random.uniform(0.0, 0.1);
    LocalGrid grid(options);
    test::CostmapOracle oracle(options);
    std::vector<Segment> walls;
    const Vector2 middle{random.uniform(-50, 50), random.uniform(-50, 50)};
    for (int i = 0; i < 6; ++i) {
      const Vector2 a = middle + Vector2{random.uniform(-2, 2), random.uniform(-2, 2)};
      walls.push_back({a, a + Vector2{random.uniform(-2, 2), random.uniform(-2, 2)}});
    }
    Pose2 X_OB{middle.x(), middle.y(), random.uniform(-3, 3)};
    for (int k = 0; k < 4; ++k) {
      Sweep sweep(1.0 + 0.1 * k, X_OB * Pose2{0.2, 0.05, 0.1}, 60, 5.0);
      sweep.look_at(walls, 0.01, seed * 10 + static_cast<std::uint64_t>(k));
      for (const float odd : {kInf, kNaN, -kInf, 0.0F, -1.0F, 0.03F, 25.0F})
        sweep.ranges[static_cast<std::size_t>(random.uniform(0, 60))] = odd;
      const std::vector<Disc> people{
          {middle + Vector2{random.uniform(-1, 1), random.uniform(-1, 1)}, random.uniform(0.0, 0.3)}};
      ASSERT_EQ(grid.add(sweep.scan, X_OB, {0.25, {}}, people), SweepFault::none);
      oracle.add(sweep.scan, X_OB, 0.25, people, grid.cells());
      for (int row = 0; row < grid.cells().height; ++row) {
        for (int column = 0; column < grid.cells().width; ++column) {
          ASSERT_EQ(grid.cells().at(column, row), oracle.value(grid.cells(), column, row))
              << "sweep " << k << " cell " << column << "," << row;
          occupied += grid.cells().at(column, row) > 0;
        }
      }
      X_OB = X_OB * Pose2{random.uniform(-0.2, 0.3), 0.0, random.uniform(-0.4, 0.4)};
    }
  }
  EXPECT_GT(occupied, 10'000);  // the maps are not empty
}

// A wall 0.425 m beside the robot, through the middle of a row of cells: a beam of 6 degrees crosses five
// cells of that row before it ends. All 60 cells from 0.5 m to 3.5 m ahead stay marked for 50 noisy sweeps;
// without the surface between neighbouring hits, grazing beams clear many of them.
TEST(LocalGrid, GrazingBeamsDoNotClearAWall) {
  const std::vector<Segment> wall{{{-5.0, 0.425}, {5.0, 0.425}}};
  for (const double link_gap : {0.3, 0.0}) {
    LocalGrid grid({.link_gap = link_gap});
    int lost = 0;
    for (int k = 0; k < 50; ++k) {
      Sweep sweep(0.1 * k, {0.0, 0.0, 0.0}, 720, 1.5 * std::numbers::pi);
      sweep.look_at(wall, 0.01, static_cast<std::uint64_t>(k));
      ASSERT_EQ(add(grid, sweep), SweepFault::none);
      if (k < 2) continue;
      for (double x = 0.525; x < 3.5; x += 0.05)
        lost += value_at(grid, {x, 0.425}) != OccupancyGrid::kOccupied;
    }
    if (link_gap > 0.0) {
      EXPECT_EQ(lost, 0);
    } else {
      EXPECT_GT(lost, 100);
    }
  }
}

// What goes away had at most four points of evidence: gone with the fourth sweep that looks through it.
TEST(LocalGrid, ClearsWhatWentAwayInFourSweeps) {
  LocalGrid grid({});
  double t = 0.0;
  for (int k = 0; k < 30; ++k, t += 0.1) {
    Sweep sweep(t, {}, 720, 4.7);
    sweep.look_at({{{2.025, -0.2}, {2.025, 0.2}}});
    add(grid, sweep);
  }
  ASSERT_EQ(value_at(grid, {2.025, 0.0}), OccupancyGrid::kOccupied);
  for (int k = 1; k <= 4; ++k, t += 0.1) {
    EXPECT_EQ(value_at(grid, {2.025, 0.0}), OccupancyGrid::kOccupied) << k;
    add(grid, Sweep(t, {}, 720, 4.7, kInf));
  }
  EXPECT_EQ(value_at(grid, {2.025, 0.0}), OccupancyGrid::kFree);
}

// A single beam's hit needs a second sweep; several beams on one surface do not.
TEST(LocalGrid, MarksASurfaceAtOnceAndASpeckAtTheSecondSweep) {
  LocalGrid grid({});
  Sweep sweep(0.0, {}, 720, 4.7, kInf);
  sweep.ranges[360] = 2.0F;
  sweep.ranges[200] = 1.5F;
  sweep.ranges[201] = 1.5F;
  const auto position_of = [&](std::size_t i) {
    return Vector2(static_cast<double>(sweep.ranges[i]) *
                   direction(sweep.scan.angle_min + static_cast<double>(i) * sweep.scan.angle_increment));
  };
  add(grid, sweep);
  EXPECT_NE(value_at(grid, position_of(360)), OccupancyGrid::kOccupied);
  EXPECT_EQ(value_at(grid, position_of(200)), OccupancyGrid::kOccupied);
  sweep.scan.time = Time::seconds(0.1);
  add(grid, sweep);
  EXPECT_EQ(value_at(grid, position_of(360)), OccupancyGrid::kOccupied);
}

TEST(LocalGrid, TakesReadingsThatAreNoneAsUnknown) {
  for (const float odd : {kNaN, -kInf, -1.0F, 0.0F, 0.03F, 20.5F, 1e30F}) {
    SCOPED_TRACE(odd);
    LocalGrid grid({});
    ASSERT_EQ(add(grid, Sweep(0.0, {}, 720, 4.7, odd)), SweepFault::none);
    for (int row = 0; row < 200; ++row) {
      for (int column = 0; column < 200; ++column) {
        const bool under_robot = grid.cells().center(column, row).norm() <= 0.25;
        ASSERT_EQ(grid.cells().at(column, row), under_robot ? OccupancyGrid::kFree : OccupancyGrid::kUnknown);
      }
    }
  }
}

// +inf clears up to raytrace_max_range (3 m here), a hit beyond it too, and nothing is marked beyond
// obstacle_max_range (2 m).
TEST(LocalGrid, KeepsTheTwoRangesApart) {
  const GridOptions options{.obstacle_max_range = 2.0, .raytrace_max_range = 3.0};
  for (const float range : {kInf, 4.0F, 2.5F, 1.9F}) {
    SCOPED_TRACE(range);
    LocalGrid grid(options);
    add(grid, Sweep(0.0, {}, 1440, 4.7, range));
    const double clear = range > 3.0F ? 2.9 : static_cast<double>(range) - 0.1;
    EXPECT_EQ(value_at(grid, {clear, 0.0}), OccupancyGrid::kFree);
    EXPECT_EQ(value_at(grid, {std::min(3.0, static_cast<double>(range)) + 0.1, 0.0}),
              OccupancyGrid::kUnknown);
    long marked = 0;
    for (const std::int8_t value : grid.cells().cells) marked += value > 0;
    EXPECT_EQ(marked > 0, range < 2.0F);
  }
}

TEST(LocalGrid, RefusesSweepsThatAreNoneAndStaysAsItWas) {
  LocalGrid grid({});
  const Sweep sound(1.0, {}, 720, 4.7, 2.0F);
  ASSERT_EQ(add(grid, sound), SweepFault::none);
  const std::vector<std::int8_t> before = grid.cells().cells;
  const auto refuse = [&](SweepFault expected, auto change) {
    Sweep sweep(1.1, {}, 720, 4.7, kInf);
    change(sweep.scan);
    EXPECT_EQ(add(grid, sweep), expected) << to_text(expected);
    EXPECT_EQ(grid.cells().cells, before);
  };
  const std::vector<float> more(900, 1.0F);
  const auto first = [&](std::size_t n) { return std::span<const float>(more).first(n); };
  refuse(SweepFault::wrong_length, [&](LaserSweep& s) { s.ranges = first(722); });
  refuse(SweepFault::wrong_length, [&](LaserSweep& s) { s.ranges = first(718); });
  refuse(SweepFault::wrong_length, [&](LaserSweep& s) { s.ranges = {}; });
  refuse(SweepFault::wrong_length, [&](LaserSweep& s) { s.angle_increment = -s.angle_increment; });
  refuse(SweepFault::bad_angles, [&](LaserSweep& s) { s.angle_increment = 0.0; });
  refuse(SweepFault::bad_angles, [&](LaserSweep& s) { s.angle_increment = std::nan(""); });
  refuse(SweepFault::wrong_length, [&](LaserSweep& s) { s.angle_max = 1e9; });
  refuse(SweepFault::bad_angles, [&](LaserSweep& s) { s.angle_min = std::nan(""); });
  refuse(SweepFault::bad_limits, [&](LaserSweep& s) { s.range_max = s.range_min; });
  refuse(SweepFault::bad_limits, [&](LaserSweep& s) { s.range_max = std::nan(""); });
  refuse(SweepFault::bad_pose, [&](LaserSweep& s) { s.X_FL.x = std::nan(""); });
  refuse(SweepFault::bad_pose, [&](LaserSweep& s) { s.X_FL.y = 1e12; });
  refuse(SweepFault::not_later, [&](LaserSweep& s) { s.time = Time::seconds(1.0); });
  refuse(SweepFault::not_later, [&](LaserSweep& s) { s.time = Time::seconds(0.5); });
  Sweep one_more(1.1, {}, 721, 4.7 * 720.0 / 719.0, 2.0F);
  *one_more.scan.angle_max -= one_more.scan.angle_increment;
  EXPECT_EQ(add(grid, one_more), SweepFault::none);
}

// The window follows the robot; what stands, stays in its place, and the memory in its own.
TEST(LocalGrid, RollsWithTheRobot) {
  LocalGrid grid({});
  const std::vector<Segment> wall{{{3.0, -1.0}, {3.0, 1.0}}};
  const std::int8_t* memory = grid.cells().cells.data();
  for (int k = 0; k < 40; ++k) {
    Sweep sweep(0.1 * k, {-1.5 + 0.0733 * k, 0.02 * k, 0.0}, 720, 4.7);
    sweep.look_at(wall);
    add(grid, sweep);
    const Vector2 center = grid.cells().origin + Vector2{5.0, 5.0};
    EXPECT_LE((center - sweep.scan.X_FL.position()).cwiseAbs().maxCoeff(), 0.05 + 1e-9);
    if (k > 1) {
      EXPECT_GT(value_at(grid, {3.001, 0.3}) + value_at(grid, {2.999, 0.3}), 90) << k;
    }
  }
  EXPECT_EQ(grid.cells().cells.data(), memory);
  // 20 m away and back: nothing is known there any more.
  add(grid, Sweep(5.0, {20.0, 0.0, 0.0}, 720, 4.7));
  add(grid, Sweep(5.1, {1.0, 0.0, 0.0}, 720, 4.7));
  EXPECT_EQ(value_at(grid, {3.001, 0.3}), OccupancyGrid::kUnknown);
}

// Seen 5 times (young) or 12 times (settled), then nobody looks: it fades after young_time (0.45 s) or
// decay_time.
TEST(LocalGrid, ForgetsWhatNobodySees) {
  for (const int sweeps : {5, 12}) {
    LocalGrid grid({.decay_time = 3.0});
    double t = 0.0;
    for (int k = 0; k < sweeps; ++k, t += 0.1) {
      Sweep sweep(t, {}, 720, 4.7);
      sweep.look_at({{{2.025, -0.2}, {2.025, 0.2}}});
      add(grid, sweep);
    }
    const double last_hit = t - 0.1;
    for (; t < 5.0; t += 0.1) {
      add(grid, Sweep(t, {}, 720, 4.7, kNaN));
      const double keep = sweeps < 10 ? 0.45 : 3.0;
      if (std::abs(t - last_hit - keep) < 1e-3) continue;  // may fall on either side by rounding
      EXPECT_EQ(value_at(grid, {2.025, 0.0}),
                t - last_hit < keep ? OccupancyGrid::kOccupied : OccupancyGrid::kUnknown)
          << t - last_hit;
    }
  }
}

// Somebody stood long enough to be furniture; as soon as a track says that it is a person, the cells are
// free, and nothing is marked within the radius and the margin.
TEST(LocalGrid, LeavesPeopleOut) {
  LocalGrid grid({});
  const std::vector<Segment> person{{{2.0, -0.1}, {2.0, 0.1}}, {{2.0, 0.1}, {2.1, 0.3}}};
  for (int k = 0; k < 20; ++k) {
    Sweep sweep(0.1 * k, {}, 720, 4.7);
    sweep.look_at(person);
    add(grid, sweep);
  }
  ASSERT_GT(value_at(grid, {2.01, 0.0}) + value_at(grid, {1.99, 0.0}), 0);
  Sweep sweep(2.0, {}, 720, 4.7);
  sweep.look_at(person);
  add(grid, sweep, {{{2.1, 0.0}, 0.3}});
  for (const std::int8_t value : grid.cells().cells) EXPECT_LE(value, 0);
  EXPECT_EQ(value_at(grid, {2.01, 0.0}), OccupancyGrid::kFree);
}

// Range noise of 1 cm, a wall askew to the cells: the surface positions lie on it within 1 cm, and cell
// centres only within half a diagonal (3.5 cm).
TEST(LocalGrid, KnowsTheSurfaceBetterThanItsCells) {
  const Segment wall{{1.5, -2.0}, {2.2, 2.0}};
  LocalGrid grid({});
  for (int k = 0; k < 20; ++k) {
    Sweep sweep(0.1 * k, {}, 720, 4.7);
    sweep.look_at({wall}, 0.01, static_cast<std::uint64_t>(k));
    add(grid, sweep);
  }
  const OccupancyGrid& cells = grid.cells();
  double sum = 0.0;
  double worst = 0.0;
  int count = 0;
  for (int row = 0; row < cells.height; ++row) {
    for (int column = 0; column < cells.width; ++column) {
      const bool faces_free = column > 0 && cells.at(column - 1, row) == OccupancyGrid::kFree;
      if (cells.at(column, row) <= 0 || !faces_free) continue;
      const Vector2 position = cells.center(column, row) +
                               cells.resolution * grid.surface()[cells.index(column, row)].cast<double>();
      const double off = (nearest_point(wall, position) - position).norm();
      sum += off;
      worst = std::max(worst, off);
      ++count;
    }
  }
  ASSERT_GT(count, 60);
  EXPECT_LT(sum / count, 0.005);
  EXPECT_LT(worst, 0.02);
}

// A wall 1 m ahead, all along the window of 4 x 4 m. Of the columns of cells around y = 0.3 a square of 1 m
// takes those with
// |y - 0.3| <= 0.5 m.
TEST(LocalGrid, ForgetsInsideAndOutsideOfASquare) {
  const GridOptions options{.width = 4.0, .height = 4.0};
  Sweep sweep(1.0, {}, 1441, 3.0);
  sweep.look_at({{{1.02, -3.0}, {1.02, 3.0}}});
  for (const bool inside : {true, false}) {
    LocalGrid grid(options);
    ASSERT_EQ(add(grid, sweep), SweepFault::none);
    const OccupancyGrid before = grid.cells();
    const std::vector<Eigen::Vector2f> surface = grid.surface();
    const Vector2 center{1.0, 0.3};
    inside ? grid.clear_inside(center, 1.0) : grid.clear_outside(center, 1.0);
    int kept = 0;
    int forgotten = 0;
    for (int row = 0; row < before.height; ++row) {
      for (int column = 0; column < before.width; ++column) {
        const Vector2 p = before.center(column, row);
        const bool is_inside = std::abs(p.x() - 1.0) <= 0.5 && std::abs(p.y() - 0.3) <= 0.5;
        const std::size_t i = before.index(column, row);
        if (is_inside == inside) {
          EXPECT_EQ(grid.cells().cells[i], OccupancyGrid::kUnknown);
          EXPECT_EQ(grid.surface()[i], Eigen::Vector2f::Zero());
          forgotten += before.cells[i] > 0 ? 1 : 0;
        } else {
          EXPECT_EQ(grid.cells().cells[i], before.cells[i]);
          EXPECT_EQ(grid.surface()[i], surface[i]);
          kept += before.cells[i] > 0 ? 1 : 0;
        }
      }
    }
    EXPECT_EQ(inside ? forgotten : kept, 20);  // cells of 5 cm in 1 m of wall
    EXPECT_GT(inside ? kept : forgotten, 20);
    // What is still there stands again after one sweep.
    sweep.scan.time = Time::seconds(1.1);
    ASSERT_EQ(add(grid, sweep), SweepFault::none);
    EXPECT_EQ(value_at(grid, {1.02, 0.3}), OccupancyGrid::kOccupied);
    sweep.scan.time = Time::seconds(1.0);
  }
}

}  // namespace
}  // namespace bw::costmap
