// A hall of 14 x 6 m, and somebody who draws keep-out zones while the robot drives from (0, 0) to (10, 0): by
// the truth of the simulated world no part of it is ever in one. In lock-step.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/navigation_status.hpp>
#include <bandwagon_msgs/srv/draw_polygon.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/files/map_file.hpp"
#include "components/messages/geometry.hpp"
#include "tests/components/files/map_files.hpp"
#include "tests/components/service_calls.hpp"

namespace bw {
namespace {

using bandwagon_msgs::srv::DrawPolygon;
using testing::HasSubstr;
namespace codes = bandwagon_msgs::msg::NavigationStatus_Constants;

constexpr double kRadius = 0.3;  // of config/robots/generic.yaml [m]
const std::string kWalls =
    "[{x1: -2, y1: -3, x2: 12, y2: -3}, {x1: 12, y1: -3, x2: 12, y2: 3}, {x1: 12, y1: 3, x2: -2, y2: 3}, "
    "{x1: -2, y1: 3, x2: -2, y2: -3}]";

struct Zone {
  Vector2 low;
  Vector2 high;
  double distance(const Vector2& p) const { return (p - p.cwiseMax(low).cwiseMin(high)).norm(); }
};

struct Drawn {
  double seconds = 0.0;
  Zone zone;
};

struct Drive {
  std::vector<double> times;   ///< of the truth [s]
  std::vector<Vector2> truth;  ///< of base_link, in map
  bandwagon_msgs::msg::NavigationStatus last;
  std::vector<DrawPolygon::Response> responses;

  /// Of the robot's outline from the zone, from `since` on [m].
  double closest(const Zone& zone, double since = 0.0) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < truth.size(); ++i)
      if (times[i] >= since) least = std::min(least, zone.distance(truth[i]) - kRadius);
    return least;
  }
};

DrawPolygon::Request request_for(const Zone& zone) {
  DrawPolygon::Request request;
  request.polygon().header().frame_id("map");
  for (const Vector2& corner :
       {zone.low, Vector2(zone.high.x(), zone.low.y()), zone.high, Vector2(zone.low.x(), zone.high.y())}) {
    geometry_msgs::msg::Point32 point;
    point.x(static_cast<float>(corner.x()));
    point.y(static_cast<float>(corner.y()));
    request.polygon().polygon().points().push_back(point);
  }
  request.value(100);
  return request;
}

/// Ends with the goal, whatever becomes of it.
Drive drive(const std::vector<Drawn>& drawn, const std::vector<std::string>& more = {}) {
  Drive result;
  std::vector<TimedRequest<DrawPolygon>> requests;
  for (const auto& [seconds, zone] : drawn) requests.push_back({seconds, request_for(zone)});
  const auto script = [&](bw::Setup& setup) {
    setup.input<bandwagon_msgs::msg::GroundTruth>(
        "/sim/ground_truth", Qos::standard(), [&](const auto& m, const Tick&) {
          result.times.push_back(seconds_since_start(from_stamp(m.header().stamp())));
          result.truth.push_back(from_pose(m.pose()).position());
        });
    setup.input<bandwagon_msgs::msg::NavigationStatus>(
        "navigation_status", Qos::latched(), [&, finish = setup.finish_run()](const auto& m, const Tick&) {
          result.last = m;
          if (m.status() >= codes::SUCCEEDED) finish(true, "the goal has ended");
        });
    call_at<DrawPolygon>(setup, "keepout_filter_mask_server/draw_polygon", requests, result.responses);
  };
  std::vector<std::string> set = {"world.walls=" + kWalls, "map_server.walls=" + kWalls,
                                  "keepout_filter_mask_server.enabled=true"};
  set.insert(set.end(), more.begin(), more.end());
  std::vector<ExtraComponent> extra;
  extra.push_back({"script", std::make_unique<Script>(script)});
  Host host(load_graph(std::filesystem::path(BANDWAGON_SOURCE_DIR) / "config/graphs/map_drive.yaml", set),
            {.clock = ClockMode::lockstep, .seed = 7}, std::move(extra));
  const RunEnd end = host.run(Duration::seconds(60.0));
  EXPECT_FALSE(end.has_thrown) << end.reason;
  for (const auto& response : result.responses) EXPECT_TRUE(response.success()) << response.message();
  return result;
}

// The zone is saved as map_server has it, and there from the start: the hall is open at its left side alone.
TEST(KeepoutDrive, RoundAZoneOfAFile) {
  const test::TemporaryFolder folder;
  OccupancyGrid mask{.resolution = 0.05, .origin = {4.0, -3.0}, .width = 20, .height = 80};
  mask.cells.assign(20 * 80, OccupancyGrid::kOccupied);
  save_map(mask, folder / "hall_keepout.yaml", {});
  const Drive seen = drive({}, {"keepout_filter_mask_server.map=" + (folder / "hall_keepout.yaml").string()});
  EXPECT_EQ(seen.last.status(), codes::SUCCEEDED) << seen.last.reason();
  const Zone zone{{4.0, -3.0}, {5.0, 1.0}};
  EXPECT_GE(seen.closest(zone), 0.0);
  EXPECT_LT(seen.closest(zone), 1.0);  // it went past it
}

// At 4 s it is at x = 2.5 or so, at 1 m/s, with 2 m to go to the zone.
TEST(KeepoutDrive, RoundAZoneThatIsDrawnAcrossItsWay) {
  const Zone zone{{4.5, -3.0}, {5.5, 1.0}};
  const Drive seen = drive({{4.0, zone}});
  EXPECT_EQ(seen.last.status(), codes::SUCCEEDED) << seen.last.reason();
  EXPECT_GE(seen.closest(zone), 0.0);
  EXPECT_LT(seen.closest(zone), 1.0);
}

// From the laser's costmap or from the map's obstacles, whatever the local planner hears.
TEST(KeepoutDrive, WithObstaclesOfTheMapToo) {
  const Zone zone{{4.5, -3.0}, {5.5, 1.0}};
  const Drive seen = drive({{4.0, zone}}, {"local_costmap.enabled=false", "obstacles.enabled=true"});
  EXPECT_EQ(seen.last.status(), codes::SUCCEEDED) << seen.last.reason();
  EXPECT_GE(seen.closest(zone), 0.0);
}

// The path in hand would lead there: the robot stands before the zone, and the goal ends with that reason.
TEST(KeepoutDrive, NotToAGoalThatAZoneHasTaken) {
  const Zone zone{{8.0, -3.0}, {12.0, 3.0}};
  const Drive seen = drive({{4.0, zone}});
  EXPECT_EQ(seen.last.status(), codes::ABORTED);
  EXPECT_THAT(seen.last.reason(), HasSubstr("(10.00, 0.00) lies in a keep-out zone"));
  EXPECT_GE(seen.closest(zone), 0.0);
}

// It brakes from v = 1 m/s and stays. With a = stop_deceleration = 2 m/s^2 and j = jerk_max = 5 m/s^3 that
// takes v / 2 (v / a + a / j) = 0.45 m, after at most 0.3 s: two periods of 0.1 s, and what a command takes.
TEST(KeepoutDrive, NoFartherWhereAZoneIsDrawnOverIt) {
  const Zone zone{{-1.0, -2.9}, {11.0, 2.9}};
  const Drive seen = drive({{4.0, zone}});
  EXPECT_EQ(seen.last.status(), codes::ABORTED);
  EXPECT_THAT(seen.last.reason(), HasSubstr("lies in a keep-out zone"));
  const auto drawn = std::ranges::lower_bound(seen.times, 4.0) - seen.times.begin();
  const Vector2 there = seen.truth[static_cast<std::size_t>(drawn)];
  for (std::size_t i = static_cast<std::size_t>(drawn); i < seen.truth.size(); ++i)
    ASSERT_LE((seen.truth[i] - there).norm(), 0.45 + 0.3) << seen.times[i];
}

}  // namespace
}  // namespace bw
