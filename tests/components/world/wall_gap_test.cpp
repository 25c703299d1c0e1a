// Gaps of outlines to walls, pillars and cells of a map, and how such a robot is stopped by them.
#include "components/world/wall_gap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "components/model/footprint_outline.hpp"
#include "components/model/nearest_point.hpp"
#include "components/model/random.hpp"
#include "components/world/world.hpp"

namespace bw {
namespace {

constexpr const char* kText = "[[0.255, 0.215], [-0.255, 0.215], [-0.255, -0.215], [0.255, -0.215]]";
const Footprint kRectangle = footprint_of(kText, 0.0).footprint;

OccupancyGrid random_map(Random& random) {
  OccupancyGrid map;
  map.resolution = 0.05;
  map.origin = {-2.0, -2.0};
  map.width = map.height = 80;
  map.cells.assign(6400, 0);
  for (std::int8_t& cell : map.cells) cell = random.uniform() < 0.01 ? 100 : 0;
  return map;
}

/// Points of the outline, 2 mm apart.
double sampled_gap(const StaticScene& scene, const Footprint& footprint, const Pose2& pose) {
  double gap = std::numeric_limits<double>::infinity();
  const std::vector<Vector2> corners = outline(footprint, pose, 0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2 side = corners[(i + 1) % corners.size()] - corners[i];
    const int steps = 1 + static_cast<int>(side.norm() / 0.002);
    for (int k = 0; k <= steps; ++k) gap = std::min(gap, scene.clearance(corners[i] + side * k / steps, 9.0));
  }
  return gap;
}

TEST(WallGap, EqualsTheGapOfPointsOnTheOutline) {
  Random random(321);
  int free = 0, in_walls = 0;
  for (int world = 0; world < 12; ++world) {
    StaticObstacles shapes;
    for (int i = 0; i < 3; ++i) {
      const Vector2 at(random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0));
      shapes.segments.push_back({at, at + random.uniform(0.1, 1.0) * direction(random.uniform(-3.1, 3.1))});
      shapes.discs.push_back(
          {{random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)}, random.uniform(0.05, 0.2)});
    }
    const bool has_map = world % 3 != 0;
    const StaticScene scene(shapes, has_map ? std::optional(random_map(random)) : std::nullopt);
    for (int i = 0; i < 60; ++i) {
      const Pose2 pose{random.uniform(-2.5, 2.5), random.uniform(-2.5, 2.5), random.uniform(-3.1, 3.1)};
      const double gap = wall_gap(scene, kRectangle, pose, 1.0);
      const double sampled = std::min(1.0, sampled_gap(scene, kRectangle, pose));
      if (gap > 0.0) {
        // Between two samples 2 mm apart the gap is less by 1 mm at most.
        EXPECT_LE(gap, sampled + 1e-9);
        EXPECT_GE(gap, sampled - 1e-3) << world << " " << i;
        ++free;
      } else {
        in_walls += sampled < 1e-3;
      }
    }
  }
  EXPECT_GT(free, 100);
  EXPECT_GT(in_walls, 20);
}

TEST(WallGap, OfADiscIsThatOfItsCentreLessTheRadius) {
  const StaticScene scene({.segments = {{{-3.0, 1.0}, {3.0, 1.0}}}}, {});
  EXPECT_EQ(wall_gap(scene, {0.3, {}}, {0.5, 0.2, 1.0}, 5.0), 0.8 - 0.3);
  EXPECT_EQ(wall_gap(scene, {0.3, {}}, {0.5, 0.2, 1.0}, 0.1), 0.4 - 0.3);
}

Robot rectangle() {
  Robot robot;
  robot.footprint = kText;
  return robot;
}

/// Between two walls 0.5 m apart; a person stands where `person` is.
struct Passage {
  explicit Passage(const Robot& its_robot, const Vector2& person = {9.0, 9.0}) : robot(its_robot) {
    WorldOptions options;
    options.start = {.x = 0.0, .y = 0.0, .theta = 0.0};
    options.walls = {{.x1 = 1.0, .y1 = 0.25, .x2 = 4.0, .y2 = 0.25},
                     {.x1 = 1.0, .y1 = -0.25, .x2 = 4.0, .y2 = -0.25}};
    options.people.scripted = {{.waypoints = {{.x = person.x(), .y = person.y()}}}};
    world.emplace(options, robot, WorldFiles{}, 5);
  }
  void drive(const Twist2& twist, double seconds) {
    const WheelSpeeds wheels = to_wheel_speeds(twist, robot.wheel_separation);
    for (const Duration end = world->time() + Duration::seconds(seconds); world->time() < end;) {
      world->command({wheels.left / robot.wheel_radius, wheels.right / robot.wheel_radius});
      world->step();
    }
  }
  Robot robot;
  std::optional<World> world;
};

TEST(WorldFootprint, ARectangleDrivesThroughWhereItsDiscIsStopped) {
  Passage passage(rectangle());
  passage.drive({0.5, 0.0}, 12.0);
  EXPECT_GT(passage.world->pose().x, 4.5);
  EXPECT_TRUE(passage.world->contacts().contacts().empty());

  Robot disc;
  disc.radius = kRectangle.radius;
  Passage stopped(disc);
  stopped.drive({0.5, 0.0}, 12.0);
  EXPECT_LT(stopped.world->pose().x, 1.0);
  EXPECT_EQ(stopped.world->contacts().count(ContactKind::wall), 1);
}

// In the middle of the passage a corner (0.3335 m) meets the wall at 0.25 m after asin(0.25 / 0.3335) -
// atan(0.215 / 0.255) = 0.147 rad; a step of 10 ms is 0.005 rad.
TEST(WorldFootprint, ATurnEndsWhereACornerMeetsTheWall) {
  Passage passage(rectangle());
  passage.drive({0.5, 0.0}, 5.0);
  passage.drive({0.0, 0.0}, 1.0);
  ASSERT_GT(passage.world->pose().x, 2.0);
  passage.drive({0.0, 0.5}, 3.0);
  EXPECT_LE(passage.world->pose().theta, 0.1475);
  EXPECT_GT(passage.world->pose().theta, 0.135);
  EXPECT_EQ(passage.world->contacts().count(ContactKind::wall), 1);
  EXPECT_NEAR(passage.world->wall_gap(1.0), 0.0, 2e-3);
  passage.drive({0.0, -0.5}, 0.2);
  passage.drive({0.3, 0.0}, 0.5);
  EXPECT_LT(passage.world->pose().theta, 0.1) << "it turns back freely";
}

// Somebody of 0.3 m stands 0.53 m beside the middle line: the side at 0.215 m passes at 0.015 m, the disc of
// 0.3335 m touches.
TEST(WorldFootprint, PeopleAreTouchedByTheOutline) {
  Passage passage(rectangle(), {5.5, 0.53});
  passage.drive({0.5, 0.0}, 14.0);
  EXPECT_GT(passage.world->pose().x, 6.2);
  EXPECT_EQ(passage.world->contacts().count(ContactKind::person), 0);

  Passage wider(rectangle(), {5.5, 0.53});
  wider.drive({0.5, 0.0}, 9.0);
  wider.world->set_footprint(padded(kRectangle, 0.03));
  wider.drive({0.5, 0.0}, 5.0);
  EXPECT_EQ(wider.world->contacts().count(ContactKind::person), 1);
}

TEST(WorldFootprint, NobodyBeginsInsideAWall) {
  WorldOptions options;
  options.walls = {{.x1 = 0.0, .y1 = 0.22, .x2 = 1.0, .y2 = 0.22}};
  EXPECT_NO_THROW(World(options, rectangle(), {}, 1));
  options.start.theta = 0.5;
  EXPECT_THROW(World(options, rectangle(), {}, 1), std::runtime_error);
}

}  // namespace
}  // namespace bw
