#include "components/slam/drive_replay.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/components/slam/slam_scene.hpp"

namespace bw::slam {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::StartsWith;

constexpr double kPeriod = 0.2;

// 6 m straight on through the lower corridor, a scan every 0.1 m, odometry exact, in base_link.
RecordedDrive straight_drive(std::size_t scans = 60) {
  RecordedDrive drive;
  test::Scanner scanner(test::square_of_corridors(), 0.005, 1, {.beams = 360});
  for (std::size_t k = 0; k < scans; ++k) {
    const Time time = Time::seconds(kPeriod * static_cast<double>(k));
    const Pose2 X_OB{0.1 * static_cast<double>(k), 0.0, 0.0};
    drive.odometry.push_back({time, X_OB, {0.5, 0.0}});
    const LaserSweep sweep = scanner.sweep(time, Pose2{-3.0, -4.0, 0.0} * X_OB);
    ScanSample sample;
    sample.time = time;
    sample.frame = "base_link";
    sample.geometry.angle_min = static_cast<float>(sweep.angle_min);
    sample.geometry.angle_increment = static_cast<float>(sweep.angle_increment);
    sample.geometry.range_min = 0.05F;
    sample.geometry.range_max = 20.0F;
    sample.ranges.assign(sweep.ranges.begin(), sweep.ranges.end());
    drive.scans.push_back(sample);
  }
  return drive;
}

TEST(DriveReplay, FollowsADriveWithoutFault) {
  const RecordedDrive drive = straight_drive();
  const SlamReplay replayed = replay(drive, {});
  ASSERT_EQ(replayed.scans.size(), 60U);
  EXPECT_THAT(replayed.left_out, IsEmpty());
  for (std::size_t k = 0; k < 60; ++k) {
    EXPECT_EQ(replayed.scans[k].time, drive.scans[k].time);
    EXPECT_EQ(replayed.scans[k].X_OB, drive.odometry[k].X_OB);
    EXPECT_LT(test::distance(replayed.pose(k), drive.odometry[k].X_OB), 0.03) << k;
  }
}

// Half of a sweep's time after its stamp, the pose is that of its middle: at 0.5 m/s and 0.1 s 2.5 cm on.
TEST(DriveReplay, ASweepIsOfItsMiddle) {
  RecordedDrive drive = straight_drive();
  for (ScanSample& scan : drive.scans) scan.geometry.time_increment = 0.1F / 360.0F;
  const SlamReplay replayed = replay(drive, {});
  ASSERT_EQ(replayed.scans.size(), 59U) << "the last one's middle is after the odometry";
  EXPECT_NEAR(replayed.scans[10].time.to_seconds(), 2.05, 1e-6);
  EXPECT_NEAR(replayed.scans[10].X_OB.x, 1.025, 1e-6);
}

TEST(DriveReplay, SaysWhatItLeftOut) {
  RecordedDrive drive = straight_drive();
  drive.scans[3].ranges.resize(1);
  drive.scans[4].geometry.range_max = 0.0F;
  for (const std::size_t k : {10U, 11U}) drive.scans[k].frame = "laser";
  // Odometry from 1 s to 10 s, with a gap from 6 to 7.4.
  std::erase_if(drive.odometry, [](const OdometrySample& sample) {
    const double t = sample.time.to_seconds();
    return t < 0.99 || t > 10.01 || (t > 6.01 && t < 7.39);
  });
  const SlamReplay replayed = replay(drive, {});
  // No odometry: 0, 1, 2 (3 and 4 are refused before), 31 to 36 and 51 to 59.
  EXPECT_EQ(replayed.scans.size(), 60U - 2U - 18U);
  EXPECT_THAT(
      replayed.left_out,
      ElementsAre(StartsWith("1 scans left out: "), StartsWith("1 scans left out: "),
                  "18 scans left out: no odometry at their time; first at 0.000 s in frame base_link: it "
                  "begins 1.000 s later: start to record it before the laser",
                  "2 scans of frame laser taken as if it were base_link; first at 2.000 s in frame laser: no "
                  "transform leads there: record /tf_static with one from base_link"));
}

// Upside down a scanner counts its angles the other way round: its beams reversed are those of one that
// stands upright.
TEST(DriveReplay, AScannerUpsideDownIsTheSameDrive) {
  const RecordedDrive upright = straight_drive();
  RecordedDrive drive = upright;
  FrameMount mount;
  mount.parent = "base_link";
  mount.child = "laser";
  mount.rotation = {1.0, 0.0, 0.0, 0.0};  // half a turn about x
  drive.mounts.push_back(mount);
  for (ScanSample& scan : drive.scans) {
    scan.frame = "laser";
    std::reverse(scan.ranges.begin(), scan.ranges.end());
  }
  const SlamReplay a = replay(upright, {});
  const SlamReplay b = replay(drive, {});
  EXPECT_THAT(b.left_out, IsEmpty());
  ASSERT_EQ(b.scans.size(), a.scans.size());
  for (std::size_t k = 0; k < a.scans.size(); ++k)
    EXPECT_LT(test::distance(a.pose(k), b.pose(k)), 0.01) << "order of points alone differs, scan " << k;
}

// Mounted 0.3 m ahead and turned by a quarter, the first point ahead of the scanner is to the left of the
// base.
TEST(DriveReplay, TakesTheScannersMount) {
  RecordedDrive drive = straight_drive(1);
  FrameMount mount;
  mount.parent = "base_link";
  mount.child = "laser";
  mount.translation = {0.3, 0.1, 0.5};
  mount.rotation = {0.0, 0.0, std::sqrt(0.5), std::sqrt(0.5)};
  drive.mounts.push_back(mount);
  drive.scans[0].frame = "laser";
  const SlamReplay replayed = replay(drive, {});
  ASSERT_EQ(replayed.slam.nodes().size(), 1U);
  const Pose2 X_BL = replayed.slam.nodes().begin()->second.ranges->X_BL;
  EXPECT_LT(difference(X_BL, {0.3, 0.1, 0.5 * std::numbers::pi}).norm(), 1e-12);
}

// base_footprint -> base_link -> plate, turned by a quarter and 0.2 m ahead -> laser, 0.1 m ahead of the
// plate.
TEST(DriveReplay, TakesMountsOneUponTheOther) {
  RecordedDrive drive = straight_drive(1);
  const double half = std::sqrt(0.5);
  drive.mounts = {{"plate", "laser", {0.1, 0.0, 0.1}, {0.0, 0.0, 0.0, 1.0}},
                  {"base_footprint", "base_link", {9.0, 9.0, 0.0}, {0.0, 0.0, 0.0, 1.0}},
                  {"base_link", "plate", {0.2, 0.0, 0.3}, {0.0, 0.0, half, half}}};
  drive.scans[0].frame = "laser";
  const SlamReplay replayed = replay(drive, {});
  EXPECT_THAT(replayed.left_out, IsEmpty());
  const Pose2 X_BL = replayed.slam.nodes().begin()->second.ranges->X_BL;
  EXPECT_LT(difference(X_BL, {0.2, 0.1, 0.5 * std::numbers::pi}).norm(), 1e-12);
  drive.mounts[2].parent = "laser";  // a ring leads nowhere
  EXPECT_THAT(replay(drive, {}).left_out, ElementsAre(StartsWith("1 scans of frame laser taken as if")));
}

// A clock that counts how often it is read: each scan and each piece of work takes one.
TEST(DriveReplay, TimesItsWorkByTheClockThatIsGiven) {
  double reads = 0.0;
  const SlamReplay replayed = replay(straight_drive(), {}, {.clock = [&reads] { return reads++; }});
  EXPECT_EQ(replayed.scan_times, std::vector<double>(60, 1.0));
  ASSERT_FALSE(replayed.piece_times.empty()) << "a submap is finished after 4 m";
  EXPECT_EQ(replayed.piece_times, std::vector<double>(replayed.piece_times.size(), 1.0));
}

TEST(DriveReplay, EndsWhereItsCallerSays) {
  std::size_t last = 0;
  std::size_t told = 0;
  const auto progress = [&](std::size_t done, std::size_t of) {
    EXPECT_EQ(of, 60U);
    last = done;
    return done < 20;
  };
  const auto after = [&](const SlamReplay& so_far) { EXPECT_EQ(so_far.scans.size(), ++told); };
  const SlamReplay replayed = replay(straight_drive(), {}, {.progress = progress, .after_scan = after});
  EXPECT_EQ(last, 20U);
  EXPECT_EQ(told, 20U);
  EXPECT_EQ(replayed.scans.size(), 20U);
}

// The same way twice, the second time by an odometry that counts from elsewhere: once the robot is found its
// poses are those of the first drive.
TEST(DriveReplay, GoesOnWithAnotherDrive) {
  const RecordedDrive first = straight_drive();
  RecordedDrive second = straight_drive();
  const Pose2 X_elsewhere{40.0, -7.0, 2.0};
  for (OdometrySample& sample : second.odometry) sample.X_OB = X_elsewhere * sample.X_OB;
  SlamReplay replayed = replay(first, {});
  ASSERT_TRUE(replay_more(replayed, second, {}));
  ASSERT_GT(replayed.scans.size(), 60U + 30U) << "found within the first 3 m";
  const std::size_t left_out = 120U - replayed.scans.size();
  if (left_out > 0) {
    EXPECT_THAT(replayed.left_out, ElementsAre(StartsWith(std::to_string(left_out) + " scans left out")));
  }
  for (std::size_t k = 60; k < replayed.scans.size(); ++k) {
    EXPECT_GT(replayed.scans[k].time, replayed.scans[k - 1].time);
    EXPECT_LT(test::distance(replayed.pose(k), first.odometry[k - 60 + left_out].X_OB), 0.05) << k;
  }
}

// A room that is nowhere in the map.
TEST(DriveReplay, DoesNotGoOnWhereNothingFits) {
  SlamReplay replayed = replay(straight_drive(), {});
  RecordedDrive other = straight_drive(5);
  test::Scanner scanner(test::room(3.0, 15.0), 0.005, 1, {.beams = 360});
  for (ScanSample& scan : other.scans) {
    const LaserSweep sweep = scanner.sweep(scan.time, {});
    scan.ranges.assign(sweep.ranges.begin(), sweep.ranges.end());
  }
  const std::size_t submaps = replayed.slam.submaps();
  EXPECT_FALSE(replay_more(replayed, other, {}));
  EXPECT_EQ(replayed.scans.size(), 60U);
  EXPECT_EQ(replayed.slam.submaps(), submaps);
}

TEST(DriveReplay, RefusesADriveWithoutScansOrOdometry) {
  RecordedDrive drive = straight_drive(2);
  RecordedDrive none = drive;
  none.scans.clear();
  EXPECT_THROW(replay(none, {}), std::runtime_error);
  none = drive;
  none.odometry.clear();
  EXPECT_THROW(replay(none, {}), std::runtime_error);
}

// Odometry that begins after the last scan: nothing is used, and nothing breaks.
TEST(DriveReplay, OfNoOdometryInTimeIsEmpty) {
  RecordedDrive drive = straight_drive(5);
  for (OdometrySample& sample : drive.odometry) sample.time = sample.time + Duration::seconds(100.0);
  const SlamReplay replayed = replay(drive, {});
  EXPECT_TRUE(replayed.scans.empty());
  EXPECT_THAT(replayed.left_out, ElementsAre(StartsWith("5 scans left out: no odometry at their time")));
}

}  // namespace
}  // namespace bw::slam
