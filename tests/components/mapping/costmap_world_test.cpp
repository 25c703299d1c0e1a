// The local costmap among walkers, in the simulated hallway: ghosts, walls, and shapes from cycle to cycle.
// The robot drives by encoders that err: 0.4 % between the wheels (1 cm for each metre driven and metre
// away), and noise that rotates odom by 0.014 rad over the first metre (5 cm at 3.5 m).
#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>

#include <gtest/gtest.h>

#include "components/mapping/obstacle_extraction.hpp"
#include "components/model/nearest_point.hpp"
#include "components/world/ray.hpp"
#include "tests/components/mapping/costmap_drive.hpp"
#include "tests/components/world/hallway.hpp"

namespace bw {
namespace {

using test::CostmapDrive;

WorldOptions crowded_hallway() {
  WorldOptions world = hallway();
  world.drive.mismatch = 0.004;
  world.drive.noise = 0.00003;
  return world;
}

WorldOptions empty_hallway() {
  WorldOptions world = crowded_hallway();
  world.people = {};
  return world;
}

/// Sways through the hallway at 1 m/s after a second.
Twist2 swaying(double time) {
  return time < 1.0 ? Twist2{} : Twist2{1.0, 0.3 * std::cos(0.8 * (time - 1.0))};
}

/// Cells that are occupied though no wall stands within 0.25 m (what odometry may be off behind the robot)
/// and nobody's body has covered them for half a second. A body: the disc of 0.3 m, and what half a cell's
/// diagonal and three standard deviations of a range add.
class GhostWatch {
 public:
  void look(const CostmapDrive& drive) {
    const OccupancyGrid& cells = drive.grid().cells();
    const Pose2 X_MO = drive.X_MO();
    for (int row = 0; row < cells.height; ++row) {
      for (int column = 0; column < cells.width; ++column) {
        const Vector2 p = X_MO * cells.center(column, row);
        const double away = (p - drive.world().pose().position()).norm();
        if (away > 5.5) continue;  // nobody comes from there within half a second
        const std::pair key{std::lround(p.x() / 0.05), std::lround(p.y() / 0.05)};
        for (const Person& person : drive.world().people()) {
          if ((person.position - p).norm() < person.radius + 0.035 + 0.03) covered_[key] = drive.time();
        }
        if (cells.at(column, row) <= 0 || away > 4.0 || drive.world().scene().nearest_point(p, 0.25))
          continue;
        const auto last = covered_.find(key);
        const double age = last == covered_.end() ? 1e3 : drive.time() - last->second;
        if (age > 0.05) ++seen_;
        if (age > 0.5 + 1e-6) ++ghosts_;
        oldest_ = std::max(oldest_, age);
      }
    }
  }
  long ghosts() const { return ghosts_; }
  long seen() const { return seen_; }  ///< cells left behind for any time at all
  double oldest() const { return oldest_; }

 private:
  std::map<std::pair<long, long>, double> covered_;
  long ghosts_ = 0;
  long seen_ = 0;
  double oldest_ = 0.0;
};

TEST(CostmapWorld, WalkersLeaveNoGhostsTrackedOrNot) {
  for (const bool tracked : {false, true}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << (tracked ? ", tracked" : ", not tracked"));
      CostmapDrive drive(crowded_hallway(), {}, seed);
      GhostWatch ghosts;
      for (int k = 0; k < 150; ++k) {
        drive.next_sweep(swaying(drive.time()), tracked);
        ASSERT_EQ(drive.fault(), SweepFault::none);
        ghosts.look(drive);
      }
      EXPECT_EQ(ghosts.ghosts(), 0) << "oldest " << ghosts.oldest() << " s";
      if (!tracked) {
        EXPECT_GT(ghosts.seen(), 0);  // the watch sees what is left behind at all
      }
    }
  }
}

/// Somebody walks straight at the robot, so that the points left lie in the shadow of the legs.
TEST(CostmapWorld, NoGhostsInTheShadowOfWhoComesNearer) {
  WorldOptions world = empty_hallway();
  ScriptedPersonOptions person;
  person.waypoints = {{6.0, 0.1}, {1.8, 0.0}};
  world.people.scripted = {person};
  CostmapDrive drive(world, {}, 1);
  GhostWatch ghosts;
  for (int k = 0; k < 60; ++k) {
    drive.next_sweep({}, false);
    ghosts.look(drive);
  }
  EXPECT_EQ(ghosts.ghosts(), 0) << "oldest " << ghosts.oldest() << " s";
  EXPECT_GT(ghosts.seen(), 0);
}

double distance_to(const StaticObstacles& obstacles, const Vector2& p) {
  double best = std::numeric_limits<double>::infinity();
  for (const Vector2& q : obstacles.points) best = std::min(best, (q - p).norm());
  for (const Segment& s : obstacles.segments) best = std::min(best, (nearest_point(s, p) - p).norm());
  for (const Disc& d : obstacles.discs) best = std::min(best, std::abs((d.center - p).norm() - d.radius));
  return best;
}

std::vector<Vector2> points_on(const StaticObstacles& obstacles, const Vector2& robot, double radius) {
  std::vector<Vector2> points = obstacles.points;
  for (const Segment& s : obstacles.segments) {
    const int steps = 1 + static_cast<int>((s.b - s.a).norm() / 0.05);
    for (int i = 0; i <= steps; ++i) points.push_back(s.a + (s.b - s.a) * (static_cast<double>(i) / steps));
  }
  for (const Disc& d : obstacles.discs) {
    for (int i = 0; i < 12; ++i) points.push_back(d.center + d.radius * direction(0.5236 * i));
  }
  std::erase_if(points, [&](const Vector2& p) { return (p - robot).norm() > radius; });
  return points;
}

double share(std::vector<double> values, double rank) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(rank * static_cast<double>(values.size() - 1))];
}

/// What a planner gets over 150 sweeps of a drive through the hallway.
struct Drive {
  std::vector<double> shapes;  ///< of each sweep
  std::vector<double> off;     ///< from true walls in view within 3.5 m to the nearest shape [m]
  std::vector<double> jitter;  ///< from shapes within 3 m to those of the next sweep [m]
};

Drive drive_through(bool exact, bool surface) {
  WorldOptions world = empty_hallway();
  if (exact) world.drive = {};
  CostmapDrive drive(world, {}, 7);
  Drive result;
  StaticObstacles before;
  for (int k = 0; k < 150; ++k) {
    drive.next_sweep(swaying(drive.time()), false);
    const Vector2 robot = drive.X_OB().position();
    const std::span<const Eigen::Vector2f> points(drive.grid().surface());
    const StaticObstacles now =
        extract_obstacles(drive.grid().cells(), robot, {.tolerance_cells = surface ? 0.3 : 0.5},
                          surface ? points : points.first(0))
            .obstacles;
    result.shapes.push_back(static_cast<double>(now.size()));
    if (k >= 5) {
      for (const Vector2& p : points_on(now, robot, 3.0)) result.jitter.push_back(distance_to(before, p));
      const Pose2 X_MB = drive.world().pose();
      const auto& walls = drive.world().scene().segments();
      for (const Segment& wall : walls) {
        for (const Vector2& p : points_on({.segments = {wall}}, X_MB.position(), 3.5)) {
          const Vector2 p_B = inverse(X_MB) * p;
          bool in_view = std::abs(std::atan2(p_B.y(), p_B.x())) < 2.3;
          const Vector2 offset = p - X_MB.position();
          for (const Segment& other : walls)
            in_view = in_view && ray_hit(X_MB.position(), offset.normalized(), other) > offset.norm() - 0.02;
          if (in_view) result.off.push_back(distance_to(now, inverse(drive.X_MO()) * p));
        }
      }
    }
    before = now;
  }
  return result;
}

void print(const char* name, const Drive& d) {
  std::printf("%s: off %.4f %.4f m, jitter %.4f %.4f m, shapes %.0f %.0f (50, 95 %%)\n", name,
              share(d.off, 0.5), share(d.off, 0.95), share(d.jitter, 0.5), share(d.jitter, 0.95),
              share(d.shapes, 0.5), share(d.shapes, 0.95));
}

// Measured (50 and 95 %): walls off by 0.1 and 0.8 cm, shapes move by 0.04 and 0.4 cm, 6 and 10 of them; half
// a cell (2.5 cm) off through cell centres. With encoders that err 0.4 and 2.4 cm, 0.2 and 1.2 cm, 15 and 25
// shapes: odom rotates under walls seen a moment ago.
TEST(CostmapWorld, WallsAreWhereTheyAreAndShapesKeepStill) {
  const Drive exact = drive_through(true, true);
  print("exact odometry", exact);
  EXPECT_LT(share(exact.off, 0.5), 0.003);
  EXPECT_LT(share(exact.off, 0.95), 0.012);
  EXPECT_LT(share(exact.jitter, 0.95), 0.008);
  EXPECT_LE(share(exact.shapes, 0.95), 15.0);
  const Drive erring = drive_through(false, true);
  print("erring odometry", erring);
  EXPECT_LT(share(erring.off, 0.5), 0.01);
  EXPECT_LT(share(erring.off, 0.95), 0.035);
  EXPECT_LT(share(erring.jitter, 0.95), 0.02);
  EXPECT_LE(share(erring.shapes, 0.95), 35.0);
  const Drive centres = drive_through(false, false);
  print("erring odometry, cell centres", centres);
  EXPECT_LT(share(erring.off, 0.5), 0.5 * share(centres.off, 0.5));
  EXPECT_LT(share(erring.shapes, 0.5), 0.5 * share(centres.shapes, 0.5));
}

}  // namespace
}  // namespace bw
