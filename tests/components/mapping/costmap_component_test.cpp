// The local costmap on its topics: a robot turns on an arc beside a wall, somebody walks ahead, sweeps come
// before the odometry of their time, tracks in map.
#include <cmath>
#include <limits>
#include <numbers>

#include <bandwagon_msgs/msg/obstacles.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <gtest/gtest.h>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/grid.hpp"
#include "components/model/differential_drive.hpp"
#include "components/world/ray.hpp"
#include "tests/components/component_rig.hpp"
#include "tests/components/mapping/grids.hpp"

namespace bw {
namespace {

using sensor_msgs::msg::LaserScan;

const Segment kWall{{-20.0, 1.43}, {20.0, 1.43}};  // in odom
const Pose2 kMount{0.1, 0.05, 0.2};
const Pose2 kX_MO{3.0, 2.0, 0.5};
constexpr double kFaultFrom = 2.0;  // [s]

Pose2 X_OB_at(double t) { return advance_exact({}, {0.5, 0.1}, t); }
Disc person_at(double t) { return {{1.6 + 0.4 * t, -0.6}, 0.2}; }

struct Seen {
  std::vector<bandwagon_msgs::msg::Obstacles> obstacles;
  std::vector<nav_msgs::msg::OccupancyGrid> costmaps;

  double last() const { return seconds_since_start(from_stamp(obstacles.back().header().stamp())); }
};

LaserScan sweep_at(double t) {
  LaserScan scan;
  scan.header(make_header("laser", {}));
  scan.angle_min(-2.35F);
  scan.angle_increment(4.7F / 719.0F);
  scan.angle_max(2.35F);
  scan.range_min(0.05F);
  scan.range_max(20.0F);
  const Pose2 X_OL = X_OB_at(t) * kMount;
  for (int i = 0; i < 720; ++i) {
    const Vector2 unit = direction(X_OL.theta - 2.35 + 4.7 / 719.0 * i);
    scan.ranges().push_back(static_cast<float>(
        std::min(ray_hit(X_OL.position(), unit, kWall), ray_hit(X_OL.position(), unit, person_at(t)))));
  }
  return scan;
}

/// A keep-out zone of 0.5 x 0.5 m where no beam looks: about (-1, -0.8) in odom, with the axes of map.
const Vector2 kZone{-1.0, -0.8};
OccupancyGrid zone_in_map() {
  OccupancyGrid mask{
      .resolution = 0.1, .origin = kX_MO * kZone - Vector2(0.25, 0.25), .width = 5, .height = 5};
  mask.cells.assign(25, OccupancyGrid::kOccupied);
  return mask;
}

struct Setting {
  std::string parameters;
  bool tracks = true;
  double confidence = 1.0;  ///< of the track
  bool odometry = true;
  std::string mask_frame;  ///< of the keep-out zone, told at kFaultFrom; empty: there is none
  std::function<bool(LaserScan&)> fault = [](LaserScan&) {
    return true;
  };  ///< from kFaultFrom; false: no sweep
};

Seen run(const Setting& setting) {
  Seen seen;
  const std::string yaml = "components: {local_costmap: {parameters: {" + setting.parameters + "}}}";
  run_with_script(yaml, 4.0, [&](Setup& setup) {
    setup.input<bandwagon_msgs::msg::Obstacles>(
        "obstacles", Qos::standard(50), [&](const auto& m, const Tick&) { seen.obstacles.push_back(m); });
    setup.input<nav_msgs::msg::OccupancyGrid>(
        "local_costmap", Qos::standard(50), [&](const auto& m, const Tick&) { seen.costmaps.push_back(m); });
    setup.every(Duration::milliseconds(10), "robot",
                [&setting, scan = setup.output<LaserScan>("scan", Qos::sensor()),
                 tracks = setup.output<bandwagon_msgs::msg::Tracks>("tracks"),
                 map = setup.output<nav_msgs::msg::OccupancyGrid>("map", Qos::latched()),
                 mask = setup.output<nav_msgs::msg::OccupancyGrid>("keepout_filter_mask", Qos::latched()),
                 tf = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf()),
                 tf_static = setup.output<tf2_msgs::msg::TFMessage>("/tf_static", Qos::latched())](
                    const Tick& tick) mutable {
                  const double t = seconds_since_start(tick.now);
                  if (tick.sequence == 1) {
                    tf2_msgs::msg::TFMessage mounts;
                    mounts.transforms().push_back(to_transform("base_link", "laser", tick.now, kMount));
                    tf_static.publish(mounts);
                    OccupancyGrid floor = test::empty_grid(400, 400, 0.05, {-10.0, -10.0});
                    // Only the map knows of what stands where no beam looks: at (-3, 0) in odom.
                    const Vector2 p = kX_MO * Vector2(-3.0, 0.0);
                    floor.cells[floor.index(floor.column_of(p.x()), floor.row_of(p.y()))] = 100;
                    map.publish(to_message(floor, "map", tick.now));
                  }
                  if (!setting.mask_frame.empty() && std::abs(t - kFaultFrom) < 1e-3)
                    mask.publish(to_message(zone_in_map(), setting.mask_frame, tick.now));
                  if (tick.sequence % 10 == 0) {
                    LaserScan sweep = sweep_at(t);
                    sweep.header().stamp(to_stamp(tick.now));
                    if (t < kFaultFrom || setting.fault(sweep)) scan.publish(sweep);
                  }
                  if (tick.sequence % 10 == 3 && setting.tracks) {
                    bandwagon_msgs::msg::Tracks message;
                    message.header(make_header("map", tick.now));
                    bandwagon_msgs::msg::Track track;
                    track.confidence(setting.confidence);
                    track.position(to_point(kX_MO * person_at(t).center));
                    track.velocity(to_vector3(rotate(kX_MO, Vector2(0.4, 0.0))));
                    track.radius(0.2);
                    message.tracks().push_back(track);
                    tracks.publish(message);
                  }
                  if (!setting.odometry) return;
                  tf2_msgs::msg::TFMessage message;
                  message.transforms().push_back(to_transform("map", "odom", tick.now, kX_MO));
                  const Time before = tick.now - Duration::milliseconds(20);
                  message.transforms().push_back(
                      to_transform("odom", "base_link", before, X_OB_at(seconds_since_start(before))));
                  tf.publish(message);
                });
  });
  return seen;
}

std::int8_t value_at(const nav_msgs::msg::OccupancyGrid& message, const Vector2& p) {
  OccupancyGrid grid;
  EXPECT_EQ(read_grid(message, grid), "");
  return grid.at(grid.column_of(p.x()), grid.row_of(p.y()));
}

TEST(LocalCostmapComponent, GivesCostsAndShapesTenTimesASecond) {
  const Seen seen = run({});
  EXPECT_NEAR(static_cast<double>(seen.obstacles.size()), 39.0, 1.0);
  ASSERT_EQ(seen.costmaps.size(), seen.obstacles.size());
  const auto& costs = seen.costmaps.back();
  EXPECT_EQ(costs.header().frame_id(), "odom");
  EXPECT_EQ(costs.info().width(), 200u);
  EXPECT_EQ(costs.info().height(), 200u);
  EXPECT_EQ(value_at(costs, {1.5, 1.43}), 100);  // lethal
  EXPECT_EQ(value_at(costs, {1.5, 1.18}), 99);   // 0.25 m before it: inscribed radius 0.3
  // 0.5 m before it, cell centres 10 cells apart: 252 exp(-3 * 0.2) = 138, published as
  // 1 + 97 * 137 / 251 = 53.
  EXPECT_EQ(value_at(costs, {1.5, 0.93}), 53);
  EXPECT_EQ(value_at(costs, {3.0, -0.7}), 0);
  EXPECT_EQ(value_at(costs, {1.5, 1.75}), -1);
  // The person walked away from 1.6 m; neither there nor along the path anything is left.
  for (double x = 1.3; x < 3.6; x += 0.05) EXPECT_EQ(value_at(costs, {x, -0.6}), 0) << x;

  // Every shape lies on the wall, within 1.5 cm.
  const auto& obstacles = seen.obstacles.back();
  EXPECT_EQ(obstacles.header().frame_id(), "odom");
  ASSERT_GE(obstacles.segments().size(), 1u);
  EXPECT_LE(obstacles.segments().size(), 4u);
  for (const auto& s : obstacles.segments()) {
    EXPECT_NEAR(static_cast<double>(s.y1()), 1.43, 0.015);
    EXPECT_NEAR(static_cast<double>(s.y2()), 1.43, 0.015);
  }
  EXPECT_TRUE(obstacles.points().empty());
  EXPECT_TRUE(obstacles.discs().empty());
}

// Without tracks whoever walks ahead is in the way like anything else.
TEST(LocalCostmapComponent, MarksPeopleNobodyTracks) {
  const Seen seen = run({.tracks = false});
  const Vector2 front = person_at(seen.last()).center - Vector2(0.19, 0.0);
  EXPECT_GE(value_at(seen.costmaps.back(), front), 99);
}

// Who may be furniture takes no marks away; what does not say how sure it is does.
TEST(LocalCostmapComponent, MarksWhoMayBeFurniture) {
  for (const double confidence : {0.0, 0.49, 0.5, std::numeric_limits<double>::quiet_NaN()}) {
    const Seen seen = run({.confidence = confidence});
    const Vector2 front = person_at(seen.last()).center - Vector2(0.19, 0.0);
    if (confidence < kConfirmed) {
      EXPECT_GE(value_at(seen.costmaps.back(), front), 99) << confidence;
    } else {
      EXPECT_EQ(value_at(seen.costmaps.back(), front), 0) << confidence;
    }
  }
}

TEST(LocalCostmapComponent, TakesTheMapWhereNobodyLooked) {
  EXPECT_EQ(value_at(run({}).costmaps.back(), {-3.0, 0.0}), -1);
  const Seen seen = run({.parameters = "use_map: true"});
  EXPECT_EQ(value_at(seen.costmaps.back(), {-3.0, 0.0}), 100);
  EXPECT_EQ(value_at(seen.costmaps.back(), {1.5, 1.43}), 100);
}

// The outline of the zone is half a cell within it: a square of 0.2 m around its middle, whether somebody has
// seen that floor or not.
TEST(LocalCostmapComponent, KeepOutZonesAreObstaclesAndCosts) {
  const auto near_zone = [](const bandwagon_msgs::msg::Obstacles& message) {
    double length = 0.0;
    for (const auto& s : message.segments()) {
      const Vector2 a(s.x1(), s.y1());
      const Vector2 b(s.x2(), s.y2());
      if ((a - kZone).norm() > 0.3 || (b - kZone).norm() > 0.3) continue;
      length += (b - a).norm();
      for (const Vector2& end : {a, b}) {
        const Vector2 p = (rotate(kX_MO, end - kZone)).cwiseAbs();
        EXPECT_NEAR(p.maxCoeff(), 0.2, 1e-3);
      }
    }
    return length;
  };
  const Seen seen = run({.mask_frame = "map"});
  EXPECT_EQ(near_zone(seen.obstacles.front()), 0.0);
  EXPECT_NEAR(near_zone(seen.obstacles.back()), 4 * 0.4, 1e-3);
  EXPECT_EQ(value_at(seen.costmaps.front(), kZone), -1);
  EXPECT_EQ(value_at(seen.costmaps.back(), kZone), 100);
  EXPECT_GE(seen.last(), 3.8);
}

// Where the zones are is not known: the robot is not driven.
TEST(LocalCostmapComponent, FallsSilentWhileTheZonesCannotBePlaced) {
  EXPECT_LT(run({.mask_frame = "elsewhere"}).last(), kFaultFrom + 1e-3);
}

// No word is better than an old one: the planner stops on obstacles that age.
TEST(LocalCostmapComponent, FallsSilentWithoutUsableSweeps) {
  const auto& silent = [](LaserScan&) { return false; };
  const auto& too_short = [](LaserScan& s) { return s.ranges().resize(500), true; };
  const auto& frozen_stamp = [](LaserScan& s) { return s.header().stamp(to_stamp({1})), true; };
  const auto& no_angles = [](LaserScan& s) {
    return s.angle_increment(std::numeric_limits<float>::quiet_NaN()), true;
  };
  for (const std::function<bool(LaserScan&)>& fault :
       {std::function<bool(LaserScan&)>(silent), std::function<bool(LaserScan&)>(too_short),
        std::function<bool(LaserScan&)>(frozen_stamp), std::function<bool(LaserScan&)>(no_angles)}) {
    const Seen seen = run({.fault = fault});
    ASSERT_FALSE(seen.obstacles.empty());
    EXPECT_LT(seen.last(), kFaultFrom + 1e-3);
  }
  EXPECT_TRUE(run({.odometry = false}).obstacles.empty());
}

}  // namespace
}  // namespace bw
