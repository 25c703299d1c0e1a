#include "components/lab/bench/buildings/building_drive.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "components/lab/bench/buildings/wall_index.hpp"
#include "runtime/parameters/read_parameters.hpp"
#include "runtime/parameters/yaml_file.hpp"
#include "tests/components/lab/bench/buildings/test_rooms.hpp"

namespace bw::buildings {
namespace {

constexpr std::array kBases = {DrivenBase::kobuki, DrivenBase::qbot2e, DrivenBase::eddie};

Pose2 pose_of(const ReferencePose& r) { return {r.position.x(), r.position.y(), *r.heading}; }

/// Where odometry says the robot is, in the frame of the truth's start.
Pose2 odometry_error(const RecordedDrive& drive, std::size_t i) {
  const Pose2 moved = inverse(pose_of(drive.truth.front())) * pose_of(drive.truth[i]);
  const Pose2& X_OB = drive.odometry[i].X_OB;
  return {X_OB.x - moved.x, X_OB.y - moved.y, wrap_angle(X_OB.theta - moved.theta)};
}

/// Straight on for `length` [m] in a room of 40 x 10 m.
Building straight_room(double length) {
  Building room = rectangular_room(40.0, 10.0);
  room.route = {{2.0, 4.0}, {2.0 + length, 4.0}};
  return room;
}

BuildingDriveOptions without_scans(DrivenBase base) {
  BuildingDriveOptions options;
  options.base = base;
  options.scanner.beams = 2;
  return options;
}

TEST(BuildingDrive, BasesAreThoseOfTheRobotFiles) {
  for (const DrivenBase base : kBases) {
    SCOPED_TRACE(to_text(base));
    Robot file;
    read_into(file,
              load_yaml(std::string(BANDWAGON_SOURCE_DIR) + "/config/robots/" + to_text(base) + ".yaml"),
              "robot");
    const Robot robot = robot_of(base);
    EXPECT_EQ(robot.name, file.name);
    EXPECT_EQ(robot.wheel_radius, file.wheel_radius);
    EXPECT_EQ(robot.wheel_separation, file.wheel_separation);
    EXPECT_EQ(robot.ticks_per_revolution, file.ticks_per_revolution);
    EXPECT_EQ(robot.wheel_speed_max, file.wheel_speed_max);
    EXPECT_EQ(robot.radius, file.radius);
    EXPECT_EQ(robot.limits.acc_max, file.limits.acc_max);
  }
}

// 10 Hz scans, 50 Hz odometry and truth.
TEST(BuildingDrive, EveryScanHasOdometryAndTruthOfItsStamp) {
  BuildingDriveOptions options;
  options.longest = Duration::milliseconds(10'000);
  const RecordedDrive drive = drive_through(make_building(BuildingKind::office, 1), options);
  ASSERT_EQ(drive.scans.size(), 101u);
  ASSERT_EQ(drive.odometry.size(), 501u);
  ASSERT_EQ(drive.truth.size(), 501u);
  EXPECT_EQ(drive.odometry.front().X_OB, Pose2{});
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    EXPECT_EQ(drive.scans[i].time, Time{} + Duration::milliseconds(100) * static_cast<std::int64_t>(i));
    EXPECT_EQ(drive.odometry[5 * i].time, drive.scans[i].time);
    EXPECT_EQ(drive.truth[5 * i].time, drive.scans[i].time);
    EXPECT_EQ(drive.scans[i].ranges.size(), 360u);
  }
}

/// Straight on from (2, 4) along x: the truth's heading is zero, and beams look as closed form has them.
void expect_ranges_of_the_room(const RecordedDrive& drive) {
  for (const ScanSample& scan : drive.scans) {
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
      const auto beam = static_cast<double>(i);
      const Time taken =
          scan.time + Duration::seconds(beam * static_cast<double>(scan.geometry.time_increment));
      const auto at = reference_at(drive, taken, Duration::milliseconds(20));
      ASSERT_TRUE(at);
      const double angle = static_cast<double>(scan.geometry.angle_min) +
                           beam * static_cast<double>(scan.geometry.angle_increment);
      const double range = range_in_room(at->position, *at->heading + angle, 40.0, 10.0);
      if (std::abs(range - static_cast<double>(scan.geometry.range_max)) < 1e-3) continue;
      const bool is_far = range > static_cast<double>(scan.geometry.range_max);
      // Angles come in 32 bits, which at 30 m and a slanting wall is some tenths of a millimetre.
      if (is_far) {
        EXPECT_EQ(scan.ranges[i], std::numeric_limits<float>::infinity());
      } else {
        EXPECT_NEAR(scan.ranges[i], range, 1e-3);
      }
    }
  }
}

TEST(BuildingDrive, RangesAreThoseOfTheRoom) {
  BuildingDriveOptions options;
  options.wheels = perfect_wheels_of(DrivenBase::kobuki);
  for (ScannerOptions scanner : {ScannerOptions{}, front_scanner()}) {
    scanner.noise = 0.0;
    options.scanner = scanner;
    const RecordedDrive drive = drive_through(straight_room(8.0), options);
    EXPECT_GT(drive.scans.size(), 160u);  // 16 s at 0.5 m/s
    expect_ranges_of_the_room(drive);
  }
}

// A head that turns once in 100 ms: each beam from where the robot was then; over a scan it moves by 5 cm.
TEST(BuildingDrive, BeamsOfATurningHeadAreTakenOneAfterTheOther) {
  BuildingDriveOptions options;
  options.wheels = perfect_wheels_of(DrivenBase::kobuki);
  options.scanner.noise = 0.0;
  options.scanner.time_increment = 0.1 / 360.0;
  const RecordedDrive drive = drive_through(straight_room(8.0), options);
  EXPECT_GT(drive.scans.size(), 159u);
  expect_ranges_of_the_room(drive);
}

// 8,000 ranges in which nothing is farther than the limit: their mean square is within 5 % (6 of its standard
// deviations, sqrt(2 / 8000) / 2) of what was asked.
TEST(BuildingDrive, RangesErrAsMuchAsTheOptionsSay) {
  Building room = rectangular_room(6.0, 5.0);
  room.route = {{2.0, 2.0}, {4.0, 2.0}};
  BuildingDriveOptions options;
  options.scanner.noise = 0.02;
  const RecordedDrive drive = drive_through(room, options);
  double sum = 0.0;
  int count = 0;
  for (const ScanSample& scan : drive.scans) {
    const Pose2 at = pose_of(*reference_at(drive, scan.time, Duration{}));
    for (std::size_t i = 0; i < scan.ranges.size(); ++i, ++count) {
      const double angle = at.theta - std::numbers::pi + static_cast<double>(i) * std::numbers::pi / 180.0;
      sum += std::pow(static_cast<double>(scan.ranges[i]) - range_in_room(at.position(), angle, 6.0, 5.0), 2);
    }
  }
  EXPECT_GT(count, 8'000);
  EXPECT_NEAR(std::sqrt(sum / count), 0.02, 0.001);
}

// Counts are cut to whole ticks, so that either wheel is behind by up to one: the heading by tick / b, the
// position by a tick and what such a heading does on the way.
TEST(BuildingDrive, OdometryOfWheelsThatDoNotErrIsRightToATick) {
  for (const DrivenBase base : kBases) {
    SCOPED_TRACE(to_text(base));
    BuildingDriveOptions options = without_scans(base);
    options.wheels = perfect_wheels_of(base);
    const RecordedDrive drive = drive_through(make_building(BuildingKind::office, 4), options);
    const Robot robot = robot_of(base);
    const double tick = robot.metres_per_tick(robot.wheel_radius);
    const double heading = tick / robot.wheel_separation;
    double driven = 0.0;
    for (std::size_t i = 1; i < drive.truth.size(); ++i) {
      driven += (drive.truth[i].position - drive.truth[i - 1].position).norm();
      const Pose2 error = odometry_error(drive, i);
      ASSERT_LE(std::abs(error.theta), heading * (1.0 + 1e-6) + 1e-9);
      ASSERT_LE(error.position().norm(), tick + heading * driven + 1e-9);
    }
    // What is lost to ticks has no direction: far below that bound at the end.
    EXPECT_LE(odometry_error(drive, drive.truth.size() - 1).position().norm(), 0.02 + 10.0 * tick);
  }
}

// Of a straight way s: scale adds scale * s; a mismatch e of the wheels turns the odometry by e s / b
// (model/README.md 2.2), to a tick of either wheel.
TEST(BuildingDrive, WheelsErrAsTheOptionsSay) {
  BuildingDriveOptions options = without_scans(DrivenBase::kobuki);
  options.wheels = perfect_wheels_of(DrivenBase::kobuki);
  options.wheels->scale = 0.01;
  const RecordedDrive scaled = drive_through(straight_room(20.0), options);
  const double s = scaled.truth.back().position.x() - 2.0;
  EXPECT_NEAR(s, 20.0, 0.05);
  EXPECT_NEAR(scaled.odometry.back().X_OB.x, 1.01 * s, 2e-4);

  options.wheels->scale = 0.0;
  options.wheels->mismatch = 0.004;
  const RecordedDrive bent = drive_through(straight_room(20.0), options);
  EXPECT_NEAR(bent.odometry.back().X_OB.theta, 0.004 * s / 0.230, 1e-3);
}

// The robot turns round on the spot at the far end: by pi, of which it counts pi times true over believed
// separation. A QBot 2e's are 0.230 and 0.235 m.
TEST(BuildingDrive, AWrongSeparationScalesTurns) {
  Building room = rectangular_room(40.0, 10.0);
  room.route = {{2.0, 4.0}, {6.0, 4.0}, {2.0, 4.0}};
  BuildingDriveOptions options = without_scans(DrivenBase::qbot2e);
  options.wheels = wheels_of(DrivenBase::qbot2e);
  options.wheels->mismatch = options.wheels->noise = 0.0;
  const RecordedDrive drive = drive_through(room, options);
  const double turned = std::abs(wrap_angle(*drive.truth.back().heading - *drive.truth.front().heading));
  EXPECT_NEAR(turned, std::numbers::pi, 0.02);
  EXPECT_NEAR(std::abs(drive.odometry.back().X_OB.theta), turned * 0.230 / 0.235, 1e-3);
}

// Corners are cut by up to 0.06 m (a right angle with a radius of 0.5 m leaves 0.359 m of 0.4, one of 100
// degrees 0.34), and the pursuit of the path by some more. Speeds are those asked for.
TEST(BuildingDrive, KeepsOffTheWallsAtTheSpeedAskedFor) {
  for (const BuildingKind kind : kBuildingKinds) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Building building = make_building(kind, seed);
      SCOPED_TRACE(building.name);
      const WallIndex walls(building.walls);
      const RecordedDrive drive = drive_through(building, without_scans(DrivenBase::kobuki));
      double least = 1.0;
      for (std::size_t i = 1; i < drive.truth.size(); ++i) {
        least = std::min(least, walls.clearance(drive.truth[i].position, 1.0));
        const Twist2 twist = twist_between(drive.truth[i - 1], drive.truth[i]);
        ASSERT_LE(std::abs(twist.v), 0.5 + 1e-6);
        ASSERT_LE(std::abs(twist.omega), 1.0 + 1e-6);
      }
      EXPECT_GE(least, 0.3);
      EXPECT_LT((drive.truth.back().position - building.route.back()).norm(), 0.05);
    }
  }
}

// A place seen again after a minute or more: within half a metre, with a heading that differs by less than
// half a radian, and elsewhere by more than pi less half a radian.
TEST(BuildingDrive, ComesBackInTheSameDirectionAndInTheOpposite) {
  for (const BuildingKind kind : kBuildingKinds) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Building building = make_building(kind, seed);
      SCOPED_TRACE(building.name);
      const RecordedDrive drive = drive_through(building, without_scans(DrivenBase::kobuki));
      bool same = false, opposite = false;
      for (std::size_t i = 0; i < drive.truth.size(); i += 50) {
        for (std::size_t j = i + 3'000; j < drive.truth.size(); j += 25) {
          if ((drive.truth[i].position - drive.truth[j].position).norm() > 0.5) continue;
          const double turned = std::abs(wrap_angle(*drive.truth[i].heading - *drive.truth[j].heading));
          same |= turned < 0.5;
          opposite |= turned > std::numbers::pi - 0.5;
        }
      }
      EXPECT_TRUE(same);
      EXPECT_TRUE(opposite);
    }
  }
}

bool same_scans(const RecordedDrive& a, const RecordedDrive& b) {
  return std::ranges::equal(a.scans, b.scans, [](const ScanSample& x, const ScanSample& y) {
    return x.time == y.time && x.ranges.size() == y.ranges.size() &&
           std::memcmp(x.ranges.data(), y.ranges.data(), x.ranges.size() * sizeof(float)) == 0;
  });
}

bool same_poses(const RecordedDrive& a, const RecordedDrive& b) {
  return std::ranges::equal(a.odometry, b.odometry, {}, &OdometrySample::X_OB, &OdometrySample::X_OB) &&
         std::ranges::equal(a.truth, b.truth, {}, pose_of, pose_of);
}

TEST(BuildingDrive, TheSameArgumentsGiveTheSameBytes) {
  const Building building = make_building(BuildingKind::office, 1);
  BuildingDriveOptions options;
  options.walkers = 20;
  options.longest = Duration::milliseconds(120'000);
  const RecordedDrive first = drive_through(building, options);
  const RecordedDrive again = drive_through(building, options);
  EXPECT_TRUE(same_poses(first, again));
  EXPECT_TRUE(same_scans(first, again));

  options.walkers = 0;
  const RecordedDrive alone = drive_through(building, options);
  EXPECT_TRUE(same_poses(first, alone));  // compared in pairs
  EXPECT_FALSE(same_scans(first, alone));

  options.seed = 2;
  const RecordedDrive other = drive_through(building, options);
  EXPECT_FALSE(same_poses(alone, other));
  EXPECT_FALSE(same_scans(alone, other));
}

// There and back in a room of 40 m, twice; in the second round a wall stands 1 m further ahead than the first round's.
TEST(BuildingDrive, EachRoundIsDrivenInItsOwnArrangement) {
  std::array<Building, 2> rounds{straight_room(3.0), straight_room(3.0)};
  for (Building& room : rounds) room.route = {{2.0, 4.0}, {5.0, 4.0}, {2.0, 4.0}};
  rounds[0].walls.push_back({{7.0, 1.0}, {7.0, 9.0}});
  rounds[1].walls.push_back({{8.0, 1.0}, {8.0, 9.0}});
  BuildingDriveOptions options;
  options.wheels = perfect_wheels_of(options.base);
  options.scanner.noise = 0.0;
  const Rounds driven = drive_rounds(rounds, options);
  ASSERT_EQ(driven.begin.size(), 2U);
  const auto ahead = [&](Time time) {
    const auto scan =
        std::ranges::find_if(driven.drive.scans, [&](const ScanSample& s) { return s.time >= time; });
    const ReferencePose at = *reference_at(driven.drive, scan->time, Duration::milliseconds(100));
    const auto beam =
        static_cast<std::size_t>(std::lround((-*at.heading + std::numbers::pi) / (std::numbers::pi / 180.0)));
    return at.position.x() + static_cast<double>(scan->ranges[beam % 360]);
  };
  // Along +x to half a degree of a beam, from 5 m before it.
  EXPECT_NEAR(ahead(driven.begin[0]), 7.0, 0.05);
  EXPECT_NEAR(ahead(driven.begin[1]), 8.0, 0.05);
}

TEST(BuildingDrive, RefusesScannersThatCannotBe) {
  const Building room = straight_room(1.0);
  BuildingDriveOptions options;
  options.scanner.period = Duration::milliseconds(50);  // no multiple of 20 ms
  EXPECT_THROW(drive_through(room, options), std::invalid_argument);
  options.scanner = {};
  options.scanner.time_increment = 0.001;  // 360 beams in 0.36 s
  EXPECT_THROW(drive_through(room, options), std::invalid_argument);
  options.scanner = {};
  options.scanner.beams = 1;
  EXPECT_THROW(drive_through(room, options), std::invalid_argument);
}

}  // namespace
}  // namespace bw::buildings
