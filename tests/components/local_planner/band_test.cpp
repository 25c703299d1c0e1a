#include "components/local_planner/teb/band.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "components/local_planner/teb/band_trajectory.hpp"
#include "components/model/differential_drive.hpp"

namespace bw::teb {
namespace {

Band straight(int poses, double spacing, double dt) {
  Band band;
  for (int k = 0; k < poses; ++k) band.poses.push_back({spacing * k, 0.0, 0.0, k + 1 < poses ? dt : 0.0});
  return band;
}

TEST(Interpolate, FollowsTheExactArc) {
  const Pose2 a{1.0, -2.0, 2.9};
  const Twist2 twist{0.7, 0.8};
  const Pose2 b = advance_exact(a, twist, 1.0);
  for (const double s : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    const Pose2 expected = advance_exact(a, twist, s);
    const Pose2 p = interpolate(a, b, s);
    EXPECT_NEAR(p.x, expected.x, 1e-12);
    EXPECT_NEAR(p.y, expected.y, 1e-12);
    EXPECT_NEAR(wrap_angle(p.theta - expected.theta), 0.0, 1e-12);
  }
}

// A band that stands from the first pose on, of a robot of 1 m/s: at acc_max 1 m/s^2 it goes on for 0.5 m, as an evasive
// move at stop_deceleration 2 m/s^2 for 0.25 m.
TEST(AsDriven, BrakesNoHarderThanTheBase) {
  PlanningProblem problem;
  problem.twist = {1.0, 0.0};
  const Band band = straight(11, 0.0, 0.3);
  const auto smooth = as_driven(band, problem, 2.0, false), hurried = as_driven(band, problem, 2.0, true);
  EXPECT_GE(smooth.back().time, 2.0 - 1e-9);
  EXPECT_NEAR(smooth.back().pose.x, 0.5, 0.06);
  EXPECT_NEAR(hurried.back().pose.x, 0.25, 0.06);
  EXPECT_NEAR(smooth.back().twist.v, 0.0, 1e-9);
}

// Backwards at 0.5 m/s, of which the robot has 0.2.
TEST(AsDriven, BacksNoFasterThanTheBase) {
  PlanningProblem problem;
  const auto motion = as_driven(straight(11, -0.15, 0.3), problem, 2.0, false);
  EXPECT_NEAR(motion.back().twist.v, -problem.limits.v_back_max, 1e-9);
}

TEST(BandAlong, StartsAtTheRobotEndsAtTheGoalAndKeepsSpeedLimits) {
  const Limits limits;
  const std::vector<Pose2> path{{-1, 0.1, 0}, {0, 0.1, 0}, {2, 0.1, 0}, {2, 3, 1.57}};
  const Pose2 start{0.5, 0.0, -0.4};
  const Band band = band_along(path, start, limits, BandOptions{});
  EXPECT_EQ(band.poses.front().pose(), start);
  EXPECT_EQ(band.poses.back().pose(), path.back());
  for (std::size_t i = 0; i + 1 < band.size(); ++i) {
    const double length = (band.poses[i + 1].position() - band.poses[i].position()).norm();
    EXPECT_LE(length / band.poses[i].dt, limits.v_max + 1e-9);
    EXPECT_GE(band.poses[i + 1].x, start.x - 1e-9) << "the path behind the robot is dropped";
  }
  EXPECT_NEAR(band.duration() / static_cast<double>(band.size() - 1), 0.3, 0.015);
}

TEST(BandAlong, SurvivesDegeneratePaths) {
  const Limits limits;
  for (const std::vector<Pose2>& path :
       {std::vector<Pose2>{{0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}, {{0, 0, 3.1}}, {{1e5, 0, 0}}}) {
    const BandOptions options;
    const Band band = band_along(path, {0, 0, 0}, limits, options);
    EXPECT_TRUE(band.is_finite());
    EXPECT_GE(band.size(), 3U);
    EXPECT_LE(band.size(), static_cast<std::size_t>(options.max_samples));
    for (std::size_t i = 0; i + 1 < band.size(); ++i) EXPECT_GT(band.poses[i].dt, 1e-3);
  }
}

TEST(Resample, KeepsPositionAsAFunctionOfTime) {
  Band band = straight(7, 0.2, 0.4);
  band.poses[2].dt = 0.1;
  Band sampled = band;
  resample(sampled, 23);
  ASSERT_EQ(sampled.size(), 23U);
  EXPECT_NEAR(sampled.duration(), band.duration(), 1e-12);
  for (int k = 0; k < 22; ++k) {
    const double time = k * band.duration() / 22.0;
    EXPECT_NEAR(sampled.poses[static_cast<std::size_t>(k)].x, band.pose_at(time).x, 1e-9);
  }
}

TEST(Resize, BringsTheMeanIntervalWithinFivePercentOfItsReference) {
  const BandOptions options;
  for (const double dt : {0.05, 0.22, 0.31, 0.36, 0.9}) {
    Band band = straight(41, 0.1, dt);
    resize(band, options);
    EXPECT_NEAR(band.duration() / static_cast<double>(band.size() - 1), 0.3, 0.015) << dt;
  }
}

TEST(Resize, CapsThePoseCount) {
  const BandOptions options;
  Band band = straight(41, 0.1, 100.0);
  resize(band, options);
  EXPECT_EQ(band.size(), static_cast<std::size_t>(options.max_samples));
}

TEST(Advance, CutsTheBandAtTheRobotAndKeepsTheRestOfTheTime) {
  Band band = straight(11, 0.3, 0.3);
  const Pose2 robot{0.7, 0.02, 0.0};  // a third into the third segment
  const double off = advance(band, robot, 1.0, BandOptions{});
  EXPECT_NEAR(off, 0.02, 1e-12);
  EXPECT_EQ(band.poses.front().pose(), robot);
  EXPECT_NEAR(band.duration(), 3.0 - 0.7, 1e-9);
  EXPECT_NEAR(band.poses[1].x, 0.9, 1e-12);
}

TEST(Advance, DoesNotLookBeyondItsHorizon) {
  Band band = straight(11, 0.3, 0.3);
  EXPECT_GT(advance(band, {2.9, 0.0, 0.0}, 0.5, BandOptions{}), 1.0);
}

}  // namespace
}  // namespace bw::teb
