#include "components/slam/slam_health.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "components/slam/slam.hpp"
#include "tests/components/slam/slam_scene.hpp"

namespace bw::slam {
namespace {

struct Watched {
  Slam slam{{.holds_back = true}};
  HealthWatch watch;
  Time time;
  Pose2 X_OB;

  /// One scan a tenth of a second later; `step` by odometry.
  SlamHealth add(test::Scanner& scanner, const Pose2& X_MB, const Pose2& step) {
    time = time + Duration::milliseconds(100);
    X_OB = X_OB * step;
    const Scan scan = scanner.scan(time, X_MB);
    const Tracked tracked = slam.add(scan, X_OB);
    watch.add(tracked, scan.points.size(), slam.pose(tracked.placement), time);
    return watch.health(time);
  }
};

// 60 m of bare corridor along x, seen to 10 m from its middle: nothing tells how far along it the robot is.
TEST(SlamHealth, SaysWhichDirectionACorridorHides) {
  for (const double heading : {0.0, 0.7}) {
    const StaticObstacles corridor = test::room(60.0, 2.0);
    test::Scanner scanner(corridor, 0.0, 1, {.range_max = 10.0});
    Watched watched;
    SlamHealth health;
    for (int k = 0; k < 30; ++k) health = watched.add(scanner, {0.03 * k, 0.1, heading}, {});
    ASSERT_EQ(health.state, HealthState::degraded);
    ASSERT_EQ(health.cause, HealthCause::unseen);
    // The map's x axis is the robot's first heading; a line's direction is the same after pi.
    EXPECT_NEAR(std::remainder(health.value + heading, std::numbers::pi), 0.0, 0.05);
  }
}

// In a room all of it is seen.
TEST(SlamHealth, IsOkInARoom) {
  test::Scanner scanner(test::room(8.0, 6.0), 0.01, 1);
  Watched watched;
  for (int k = 0; k < 60; ++k) {
    const SlamHealth health = watched.add(scanner, {0.05 * k, 0.0, 0.0}, {k == 0 ? 0.0 : 0.05, 0.0, 0.0});
    ASSERT_EQ(health.state, HealthState::ok) << k;
  }
}

// Wheels go 0.5 m/s, the robot stands against something: of 0.5 m in the last second scans see next to nothing.
TEST(SlamHealth, SaysThatWheelsSlip) {
  test::Scanner scanner(test::room(8.0, 6.0), 0.0, 1);
  Watched watched;
  double x = 0.0;
  SlamHealth health;
  for (int k = 0; k < 60; ++k) {
    if (k > 0 && k < 30) x += 0.05;
    health = watched.add(scanner, {x, 0.0, 0.0}, {k == 0 ? 0.0 : 0.05, 0.0, 0.0});
    if (k < 30) {
      ASSERT_EQ(health.state, HealthState::ok) << k;
    }
  }
  EXPECT_EQ(health.state, HealthState::degraded);
  EXPECT_EQ(health.cause, HealthCause::slip);
  EXPECT_NEAR(health.value, 0.5, 0.06);
  EXPECT_LT(health.by_scans, 0.1);
}

// From a room into a smaller one, without a step of odometry: lost after five scans, and none of them is in the
// map.
TEST(SlamHealth, AnotherPlaceAllAtOnceIsAKidnap) {
  test::Scanner room(test::square_of_corridors(), 0.01, 1);
  test::Scanner elsewhere(test::room(3.1, 17.0), 0.01, 2);
  Watched watched;
  for (int k = 0; k < 40; ++k)
    watched.add(room, {-5.0 + 0.05 * k, -4.0, 0.0}, {k == 0 ? 0.0 : 0.05, 0.0, 0.0});
  const std::size_t nodes = watched.slam.nodes().size();
  for (int k = 0; k < 20; ++k) {
    const SlamHealth health = watched.add(elsewhere, {0.4, 1.0 + 0.05 * k, 1.0}, {0.05, 0.0, 0.0});
    EXPECT_EQ(health.state == HealthState::lost, k >= 4) << k;
  }
  EXPECT_EQ(watched.slam.nodes().size(), nodes);
}

// From a room into one that is 2 m longer, to the same distance from the other three walls: 0.75 of the scan lie on walls of the
// first, and of these 0.29 are seen through, which leaves more than half. The robot stands, drives on from there, and is lost
// after five scans.
TEST(SlamHealth, APlaceThatFitsByThreeQuartersIsAKidnap) {
  test::Scanner room(test::room(8.0, 6.0), 0.01, 1, {.beams = 360, .field_of_view = 2.0 * std::numbers::pi});
  StaticObstacles longer;
  test::add_box(longer, {-4.0, -3.0}, {4.0, 5.0});
  test::Scanner elsewhere(longer, 0.01, 2, {.beams = 360, .field_of_view = 2.0 * std::numbers::pi});
  Watched watched;
  for (int k = 0; k < 40; ++k)
    watched.add(room, {-2.0 + 0.05 * k, -1.0, 0.0}, {k == 0 ? 0.0 : 0.05, 0.0, 0.0});
  const std::size_t nodes = watched.slam.nodes().size();
  for (int k = 0; k < 20; ++k) {
    const SlamHealth health = watched.add(elsewhere, {-0.05, -1.0, 0.0}, {});
    EXPECT_EQ(health.state == HealthState::lost, k >= 4) << k;
  }
  EXPECT_EQ(watched.slam.nodes().size(), nodes);
}

// The same offline, where nobody would look for the place: all that was driven is in the map.
TEST(SlamHealth, WhereNobodyLooksTheMapGoesOn) {
  test::Scanner room(test::square_of_corridors(), 0.01, 1);
  test::Scanner elsewhere(test::room(3.1, 17.0), 0.01, 2);
  Watched watched{.slam = Slam{SlamOptions{}}};
  for (int k = 0; k < 40; ++k)
    watched.add(room, {-5.0 + 0.05 * k, -4.0, 0.0}, {k == 0 ? 0.0 : 0.05, 0.0, 0.0});
  const std::size_t nodes = watched.slam.nodes().size();
  for (int k = 0; k < 20; ++k) {
    const SlamHealth health = watched.add(elsewhere, {0.4, 1.0 + 0.05 * k, 1.0}, {0.05, 0.0, 0.0});
    EXPECT_NE(health.state, HealthState::lost) << k;
  }
  EXPECT_GE(watched.slam.nodes().size(), nodes + 4) << "20 scans of 0.05 m, one in the map each 0.2 m";
}

// Odometry that is 2 m farther from one scan to the next.
TEST(SlamHealth, SaysThatOdometryJumped) {
  test::Scanner scanner(test::room(8.0, 6.0), 0.0, 1);
  Watched watched;
  for (int k = 0; k < 10; ++k) watched.add(scanner, {}, {});
  const SlamHealth health = watched.add(scanner, {}, {2.0, 0.0, 0.0});
  EXPECT_EQ(health.cause, HealthCause::odometry_jump);
  EXPECT_NEAR(health.value, 2.0, 1e-9);
}

}  // namespace
}  // namespace bw::slam
