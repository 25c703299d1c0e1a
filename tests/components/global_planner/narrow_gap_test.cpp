// Gaps that a rectangle just fits, and some that it does not: planned on cells of 0.05 m.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/global_planner/planner.hpp"
#include "components/model/random.hpp"

namespace bw {
namespace {

/// 0.51 x 0.43 m.
Footprint rectangle() {
  Footprint footprint{.radius = std::hypot(0.255, 0.215)};
  footprint.polygon = {{0.255, 0.215}, {-0.255, 0.215}, {-0.255, -0.215}, {0.255, -0.215}};
  return footprint;
}

OccupancyGrid floor_of(double side) {
  const int cells = static_cast<int>(side / 0.05);
  OccupancyGrid map{
      .resolution = 0.05, .origin = {-side / 2.0, -side / 2.0}, .width = cells, .height = cells};
  map.cells.assign(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells), OccupancyGrid::kFree);
  return map;
}

/// Across the floor, along y before it is rotated by `angle` about `center`: two thin walls with a gap, and
/// two more that make a corridor of `length` of it.
StaticObstacles barrier(const Vector2& center, double angle, double width, double length) {
  const Pose2 X{center.x(), center.y(), angle};
  StaticObstacles shapes;
  for (const double side : {1.0, -1.0}) {
    shapes.segments.push_back({X * Vector2(0.0, side * width / 2.0), X * Vector2(0.0, side * 9.0)});
    if (length > 0.0)
      shapes.segments.push_back(
          {X * Vector2(-length / 2.0, side * width / 2.0), X * Vector2(length / 2.0, side * width / 2.0)});
  }
  return shapes;
}

/// Largest over headings up to an eighth of a turn to either side of the pose's.
double best_gap(const Footprint& footprint, const Pose2& pose, const StaticObstacles& shapes) {
  double best = -1.0;
  for (int i = -16; i <= 16; ++i) {
    double gap = 1.0;
    for (const Segment& s : shapes.segments) {
      const double heading = pose.theta + i * std::numbers::pi / 128.0;
      gap = std::min(gap, gap_to(footprint, {pose.x, pose.y, heading}, {s.a, s.b, 0.0}));
    }
    best = std::max(best, gap);
  }
  return best;
}

struct Gap {
  const char* name;
  double angle;
  double length;
};

class NarrowGap : public testing::TestWithParam<Gap> {};

// 2 cm to either side, thirty positions of the gap between the middles of cells: passed each time, and
// wherever the path leads the rectangle fits to a millimetre in some heading.
TEST_P(NarrowGap, IsPassedWhereTheRectangleFitsByTwoCentimetres) {
  Random random(18);
  const OccupancyGrid map = floor_of(6.0);
  const Footprint footprint = rectangle();
  for (int i = 0; i < 30; ++i) {
    const Vector2 center(random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05));
    const StaticObstacles shapes = barrier(center, GetParam().angle, 0.47, GetParam().length);
    Planner planner;
    ASSERT_EQ(planner.set_map(map, footprint, shapes), "");
    const Vector2 ahead = 2.0 * direction(GetParam().angle);
    const Vector2 from = center - ahead, to = center + ahead;
    const PathResult result = planner.plan({from.x(), from.y(), 0.0}, {to.x(), to.y(), 0.0});
    ASSERT_EQ(result.status, PathStatus::ok) << i << " " << center.transpose() << ": " << result.reason;
    EXPECT_LT(result.length, 4.1);  // through it
    for (const Pose2& pose : result.path) EXPECT_GE(best_gap(footprint, pose, shapes), -2e-3) << i;
  }
}

// Half a centimetre too narrow at either side.
TEST_P(NarrowGap, IsRefusedWhereItDoesNotFit) {
  Random random(19);
  const OccupancyGrid map = floor_of(6.0);
  for (int i = 0; i < 30; ++i) {
    const Vector2 center(random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05));
    Planner planner;
    ASSERT_EQ(planner.set_map(map, rectangle(), barrier(center, GetParam().angle, 0.42, GetParam().length)),
              "");
    const Vector2 ahead = 2.0 * direction(GetParam().angle);
    const Vector2 from = center - ahead, to = center + ahead;
    const PathResult result = planner.plan({from.x(), from.y(), 0.0}, {to.x(), to.y(), 0.0});
    EXPECT_EQ(result.status, PathStatus::disconnected) << i << " " << center.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(Angles, NarrowGap,
                         testing::Values(Gap{"Gap0", 0.0, 0.0}, Gap{"Gap45", std::numbers::pi / 4.0, 0.0},
                                         Gap{"Gap90", std::numbers::pi / 2.0, 0.0}, Gap{"Gap20", 0.35, 0.0},
                                         Gap{"Corridor0", 0.0, 1.2},
                                         Gap{"Corridor45", std::numbers::pi / 4.0, 1.2},
                                         Gap{"Corridor90", std::numbers::pi / 2.0, 1.2}),
                         [](const auto& test) { return std::string(test.param.name); });

// Wide enough for the rectangle, not for the disc around it (0.667 m): the disc is told that no path leads
// there.
TEST(NarrowGapOfADisc, IsNotThatOfTheRectangle) {
  const Footprint disc{rectangle().radius, {}};
  for (const double width : {0.6, 0.7}) {
    Planner planner;
    ASSERT_EQ(planner.set_map(floor_of(6.0), disc, barrier({0.012, 0.017}, 0.0, width, 0.0)), "");
    const PathResult result = planner.plan({-2.0, 0.0, 0.0}, {2.0, 0.0, 0.0});
    EXPECT_EQ(result.status, width < 0.667 ? PathStatus::disconnected : PathStatus::ok) << result.reason;
  }
}

std::vector<Capsule> random_obstacles(Random& random) {
  std::vector<Capsule> obstacles;
  for (int i = 0; i < 6; ++i) {
    const Vector2 a(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
    const Vector2 b = a + Vector2(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2));
    obstacles.push_back({a, i % 2 == 0 ? a : b, random.uniform(0.0, 0.1)});
  }
  return obstacles;
}

// Leaving out headings that cannot differ changes nothing.
TEST(FreeHeadings, AreThoseOfEachHeadingAlone) {
  Random random(20);
  int free = 0;
  for (int i = 0; i < 500; ++i) {
    const std::vector<Capsule> obstacles = random_obstacles(random);
    const Vector2 position(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
    std::uint64_t expected = 0;
    for (int k = 0; k < kHeadings; ++k) {
      const Pose2 pose{position.x(), position.y(), k * kHeadingStep};
      const bool is_free = std::ranges::all_of(
          obstacles, [&](const Capsule& obstacle) { return gap_to(rectangle(), pose, obstacle) >= 0.0; });
      if (is_free) expected |= std::uint64_t{1} << k;
    }
    EXPECT_EQ(free_headings(rectangle(), position, obstacles), expected);
    free += expected != 0 && expected != kAllHeadings ? 1 : 0;
  }
  EXPECT_GT(free, 20);  // of 500: else it was no test
}

// Against 65 x 65 positions of the cell.
TEST(BestPosition, HasTheClearanceThatTheCellOffers) {
  Random random(21);
  double worst = 0.0;
  for (int i = 0; i < 500; ++i) {
    const std::vector<Capsule> obstacles = random_obstacles(random);
    const Vector2 center(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
    double most = -1.0;
    for (int y = -32; y <= 32; ++y) {
      for (int x = -32; x <= 32; ++x)
        most = std::max(most, clearance_of(center + 0.05 / 64.0 * Vector2(x, y), obstacles));
    }
    const NarrowCell best = best_position(center, 0.05, obstacles);
    EXPECT_LE((best.position - center).cwiseAbs().maxCoeff(), 0.025 + 1e-12);
    EXPECT_DOUBLE_EQ(best.clearance, clearance_of(best.position, obstacles));
    worst = std::max(worst, most - best.clearance);
  }
  std::printf("best place: at most %.4f m below the best of the cell\n", worst);
  EXPECT_LE(worst, 0.005);
}

}  // namespace
}  // namespace bw
