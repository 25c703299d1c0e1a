#include "components/slam/scan.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "components/model/differential_drive.hpp"
#include "components/world/ray.hpp"
#include "tests/components/slam/slam_scene.hpp"

namespace bw::slam {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// Of a normal by its doubled angle, modulo the two sides of the wall.
double normal_off(const SurfacePoint& point, double normal) {
  const double doubled =
      std::atan2(static_cast<double>(point.normal_sin2), static_cast<double>(point.normal_cos2));
  return 0.5 * std::abs(wrap_angle(doubled - 2.0 * normal));
}

double straightness(const SurfacePoint& point) {
  return std::hypot(static_cast<double>(point.normal_cos2), static_cast<double>(point.normal_sin2));
}

// A wall 2 m away whose normal points to `angle`: without noise all normals are exact but for the width of a
// float.
TEST(ScanOf, NormalsOfAStraightWallAreWithinADegree) {
  for (double angle = -2.0; angle <= 2.0; angle += 0.25) {
    const Vector2 n = direction(angle);
    const Vector2 along{-n.y(), n.x()};
    StaticObstacles wall;
    wall.segments.push_back({2.0 * n - 3.0 * along, 2.0 * n + 3.0 * along});
    const Scan scan = test::Scanner(wall, 0.0, 1).scan({}, {});
    ASSERT_GT(scan.points.size(), 50U);
    for (const SurfacePoint& point : scan.points) {
      EXPECT_NEAR(n.dot(point.position()), 2.0, 1e-5);
      EXPECT_LT(normal_off(point, angle), 1.0 * kDegree);
      EXPECT_GT(straightness(point), 0.98);
    }
  }
}

// 1 cm of noise on 9 points over 8 beams: the mean of the doubled angles stays within a degree all the same.
TEST(ScanOf, NormalsOfANoisyWallAverageToItsNormal) {
  StaticObstacles wall;
  wall.segments.push_back({{2.0, -3.0}, {2.0, 3.0}});
  test::Scanner scanner(wall, 0.01, 7);
  SurfacePoint mean;
  for (int k = 0; k < 20; ++k) {
    for (const SurfacePoint& point : scanner.scan({}, {}).points) {
      mean.normal_cos2 += point.normal_cos2;
      mean.normal_sin2 += point.normal_sin2;
    }
  }
  EXPECT_LT(normal_off(mean, 0.0), 1.0 * kDegree);
}

// Where two walls meet at a right angle the neighbours spread both ways: below the half from which a normal
// is used.
TEST(ScanOf, ACornerIsNotStraight) {
  const Scan scan = test::Scanner(test::room(4.0, 4.0), 0.0, 1).scan({}, {});
  double least = 1.0;
  for (const SurfacePoint& point : scan.points)
    if ((point.position() - Vector2{2.0, 2.0}).norm() < 0.03) least = std::min(least, straightness(point));
  EXPECT_LT(least, 0.5);
}

TEST(ScanOf, KeepsApartWhatBeamsSay) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  const std::vector<float> ranges{kNan, -kInf, 0.0F, 0.01F, kInf, 12.0F, 2.0F, 40.0F};
  LaserSweep sweep;
  sweep.time = Time::seconds(3.0);
  sweep.angle_increment = 0.5;
  sweep.range_min = 0.05;
  sweep.range_max = 30.0;
  sweep.ranges = ranges;
  SlamOptions options;
  options.max_laser_range = 10.0;
  const Scan scan = scan_of(sweep, options);
  EXPECT_EQ(scan.time, sweep.time);
  const auto none = RangeImage::kNoReturn;
  const auto unknown = RangeImage::kUnknown;
  EXPECT_EQ(scan.ranges.millimetres,
            (std::vector<std::uint16_t>{unknown, unknown, unknown, unknown, none, none, 2000, unknown}));
  ASSERT_EQ(scan.points.size(), 1U);
  EXPECT_NEAR(static_cast<double>(scan.points[0].x), 2.0 * std::cos(3.0), 1e-6);
  EXPECT_NEAR(static_cast<double>(scan.points[0].y), 2.0 * std::sin(3.0), 1e-6);
  EXPECT_EQ(straightness(scan.points[0]), 0.0) << "one point alone has no normal";
}

TEST(ScanOf, OfNothingIsNothing) {
  const std::vector<float> ranges(100, std::numeric_limits<float>::infinity());
  LaserSweep sweep;
  sweep.angle_increment = 0.01;
  sweep.range_min = 0.05;
  sweep.range_max = 30.0;
  sweep.ranges = ranges;
  EXPECT_TRUE(scan_of(sweep, {}).points.empty());
}

// A scanner that hangs upside down: the same beams the other way round are the same points with the same
// normals.
TEST(ScanOf, AnglesThatCountDownGiveTheSamePoints) {
  test::Scanner scanner(test::room(12.0, 9.0), 0.0, 1, {.beams = 181});
  const LaserSweep upright = scanner.sweep({}, {0.7, 0.2, 0.3});
  const std::vector<float> reversed(upright.ranges.rbegin(), upright.ranges.rend());
  LaserSweep upside = upright;
  upside.angle_min = upright.angle_min + 180 * upright.angle_increment;
  upside.angle_increment = -upright.angle_increment;
  upside.ranges = reversed;
  const Scan a = scan_of(upright, {});
  const Scan b = scan_of(upside, {});
  ASSERT_EQ(a.points.size(), 181U) << "beams 2.6 degrees apart end more than half a cell apart";
  ASSERT_EQ(b.points.size(), 181U);
  for (std::size_t i = 0; i < 181; ++i) {
    const SurfacePoint& p = a.points[i];
    const SurfacePoint& q = b.points[180 - i];
    EXPECT_LT((p.position() - q.position()).norm(), 1e-5);
    EXPECT_NEAR(static_cast<double>(p.normal_cos2), static_cast<double>(q.normal_cos2), 1e-4);
    EXPECT_NEAR(static_cast<double>(p.normal_sin2), static_cast<double>(q.normal_sin2), 1e-4);
  }
}

// Points closer than half a cell to the one kept before are left out: 5 m of wall seen from 2 m is at most
// 200 points.
TEST(ScanOf, PointsAreHalfACellApart) {
  test::Scanner scanner(test::room(4.0, 4.0), 0.0, 1, {.beams = 3600});
  const Scan scan = scanner.scan({}, {});
  ASSERT_GT(scan.points.size(), 100U);
  for (std::size_t i = 1; i < scan.points.size(); ++i)
    EXPECT_GE((scan.points[i].position() - scan.points[i - 1].position()).norm(), 0.025 - 1e-6);
}

// Each beam from where the scanner was: a robot that drives on while the head turns sees the wall where it
// is.
TEST(ScanOf, BeamsStartWhereTheScannerWas) {
  const std::vector<float> ranges{2.0F, 1.9F, 1.8F};
  const std::vector<Pose2> poses{{0.0, 0.0, 0.0}, {0.1, 0.1, 0.0}, {0.2, 0.2, 0.0}};
  LaserSweep sweep;
  sweep.angle_increment = 1e-9;
  sweep.range_min = 0.05;
  sweep.range_max = 30.0;
  sweep.ranges = ranges;
  sweep.beam_poses = poses;
  const Scan scan = scan_of(sweep, {});
  ASSERT_EQ(scan.points.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(static_cast<double>(scan.points[i].x), 2.0, 1e-6);
    EXPECT_NEAR(static_cast<double>(scan.points[i].y), 0.1 * static_cast<double>(i), 1e-6);
  }
}

// The head takes 0.15 s for a round while the robot drives 0.5 m/s and turns 1.5 rad/s: 0.11 rad before and
// after the middle, 0.7 m at 6 m. Drawn from the middle, beams end within a cell of the walls; what is left is
// the drive across a beam, 3.75 cm at the sweep's ends.
TEST(ScanOf, TheImageIsThatOfTheMiddleOfTheSweep) {
  constexpr int kBeams = 720;
  constexpr double kSweep = 0.15;
  const StaticObstacles walls = test::room(12.0, 9.0);
  const Pose2 mount{0.1, 0.0, 0.5};
  LaserSweep sweep;
  sweep.X_FL = mount;
  sweep.angle_min = -std::numbers::pi;
  sweep.angle_increment = 2.0 * std::numbers::pi / kBeams;
  sweep.time_increment = kSweep / kBeams;
  sweep.range_min = 0.05;
  sweep.range_max = 30.0;
  const Pose2 X_MB{1.0, 0.5, 0.3};
  std::vector<Pose2> poses;
  std::vector<float> ranges;
  for (int i = 0; i < kBeams; ++i) {
    poses.push_back(advance_exact({}, {0.5, 1.5}, i * sweep.time_increment) * mount);
    const Pose2 X_ML = X_MB * poses.back();
    double range = 30.0;
    for (const Segment& wall : walls.segments)
      range =
          std::min(range, ray_hit(X_ML.position(),
                                  direction(X_ML.theta + sweep.angle_min + i * sweep.angle_increment), wall));
    ranges.push_back(static_cast<float>(range));
  }
  sweep.ranges = ranges;
  sweep.beam_poses = poses;
  const RangeImage image = scan_of(sweep, {}).ranges;
  const Pose2 X_ML = X_MB * image.X_BL;
  double worst = 0.0;
  for (int i = 0; i < kBeams; ++i) {
    const double angle = X_ML.theta + image.angle_min + i * image.angle_increment;
    const Vector2 end =
        X_ML.position() + 0.001 * image.millimetres[static_cast<std::size_t>(i)] * direction(angle);
    worst = std::max(worst, std::min(std::abs(std::abs(end.x()) - 6.0), std::abs(std::abs(end.y()) - 4.5)));
  }
  EXPECT_LT(worst, 0.045);
}

// A beam per degree in the middle of a room of 8 x 6 m, once more 0.2 m on and turned by 0.2 rad. Of the same room with
// its upper wall at y = 5 in place of 3 m the beams between the corners at (-+4, 3) end elsewhere: 106 of 360, 0.705 are left.
TEST(SeenAlike, IsTheShareOfBeamsThatEndWhereTheOthersDid) {
  test::Scanner same(test::room(8.0, 6.0), 0.0, 1, {.beams = 360, .field_of_view = 2.0 * std::numbers::pi});
  const Scan then = same.scan({}, {});
  const Pose2 X_TN{0.2, 0.0, 0.2};
  EXPECT_GT(seen_alike(then.ranges, same.scan({}, X_TN).ranges, X_TN), 0.99);
  StaticObstacles larger;
  test::add_box(larger, {-4.0, -3.0}, {4.0, 5.0});
  test::Scanner other(larger, 0.0, 1, {.beams = 360, .field_of_view = 2.0 * std::numbers::pi});
  EXPECT_NEAR(seen_alike(then.ranges, other.scan({}, {}).ranges, {}), 0.705, 0.03);
}

// Half a circle that looks ahead, and the same from the same place when the robot has turned about: hardly a beam is in both.
TEST(SeenAlike, SaysNothingOfWhatOneOfBothDidNotLookAt) {
  test::Scanner scanner(test::square_of_corridors(), 0.0, 1,
                        {.beams = 180, .field_of_view = std::numbers::pi});
  const Scan ahead = scanner.scan({}, {-5.0, -4.0, 0.3});
  const Scan back = scanner.scan({}, {-5.0, -4.0, 0.3 + std::numbers::pi});
  EXPECT_EQ(seen_alike(ahead.ranges, back.ranges, {0.0, 0.0, std::numbers::pi}), 1.0);
}

}  // namespace
}  // namespace bw::slam
