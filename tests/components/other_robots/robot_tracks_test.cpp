// What another robot says of itself, as a track in another frame and at another time.
#include "components/other_robots/robot_tracks.hpp"

#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace bw {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kQuarter = std::numbers::pi / 2.0;
const Time kNow = Time::seconds(100.0);

/// At (4, 1) in map, driving along y at 0.8 m/s, sure to 0.1 m along x and 0.2 m along y.
RobotReport report() {
  RobotReport report{.time = kNow, .X_MR = {4.0, 1.0, kQuarter}, .twist = {0.8, 0.3}};
  report.covariance << 0.01, 0.0, 0.0, 0.04;
  return report;
}

TEST(RobotTrack, IsCarriedToTheTimeAndIntoTheFrameOfTheTracks) {
  // The frame lies at (1, 0) of map and is rotated by 90 degrees: (4, 1 + 0.08) of map is (1.08, -3) there.
  const Pose2 X_FM = inverse(Pose2{1.0, 0.0, kQuarter});
  const TrackedPerson track = robot_track(report(), X_FM, kNow + Duration::milliseconds(100), 7, 0.25, {});
  EXPECT_EQ(track.id, 7U);
  EXPECT_EQ(track.radius, 0.25);
  EXPECT_NEAR(track.position.x(), 1.08, 1e-9);
  EXPECT_NEAR(track.position.y(), -3.0, 1e-9);
  EXPECT_NEAR(track.velocity.x(), 0.8, 1e-9);  // along y of map is along x of the frame
  EXPECT_NEAR(track.velocity.y(), 0.0, 1e-9);
  EXPECT_NEAR(track.covariance(0, 0), 0.04, 1e-9);
  EXPECT_NEAR(track.covariance(1, 1), 0.01, 1e-9);
}

TEST(RobotTrack, KeepsItsVelocityAndIsLessSureTheFartherAhead) {
  const OtherRobotsOptions options{.acceleration = 0.5, .prediction_horizon = 2.0, .prediction_step = 0.5};
  const TrackedPerson track = robot_track(report(), Pose2{}, kNow, 1, 0.3, options);
  ASSERT_EQ(track.predictions.size(), 4U);
  EXPECT_EQ(track.predictions[3].time, 2.0);
  EXPECT_NEAR(track.predictions[3].position.y(), 1.0 + 2.0 * 0.8, 1e-9);
  EXPECT_NEAR(track.predictions[3].covariance(0, 0), 0.01 + 1.0, 1e-9);  // (0.5 * 2^2 / 2)^2
  EXPECT_NEAR(track.predictions[3].covariance(1, 1), 0.04 + 1.0, 1e-9);
}

TEST(RobotTrack, TheBodyIsNobodyElseAndAPersonBesideItIs) {
  const TrackedPerson robot = robot_track(report(), Pose2{}, kNow, 1, 0.3, {});
  EXPECT_TRUE(is_body_of(robot, {4.0, 1.44}, 0.15));
  EXPECT_FALSE(is_body_of(robot, {4.0, 1.60}, 0.15));  // a person of 0.3 m who touches it
}

TEST(RobotReport, IsRefusedWithAReason) {
  EXPECT_EQ(fault_of(report(), kNow, {}), "");
  RobotReport lost = report();
  lost.covariance(1, 1) = 0.26;  // 0.51 m
  EXPECT_EQ(fault_of(lost, kNow, {}), "it is not sure of its place");
  lost.covariance(1, 1) = -0.1;
  lost.covariance(0, 0) = -0.1;
  EXPECT_EQ(fault_of(lost, kNow, {}), "it is not sure of its place");
  EXPECT_EQ(fault_of(report(), kNow + Duration::milliseconds(501), {}), "its stamps are not of now");
  EXPECT_EQ(fault_of(report(), kNow - Duration::milliseconds(501), {}), "its stamps are not of now");
  RobotReport broken = report();
  broken.twist.v = kNan;
  EXPECT_EQ(fault_of(broken, kNow, {}), "its pose or velocity is not finite");
  broken = report();
  broken.covariance(0, 1) = kNan;
  EXPECT_EQ(fault_of(broken, kNow, {}), "its pose or velocity is not finite");
  broken = report();
  broken.X_MR.theta = std::numeric_limits<double>::infinity();
  EXPECT_EQ(fault_of(broken, kNow, {}), "its pose or velocity is not finite");
}

}  // namespace
}  // namespace bw
