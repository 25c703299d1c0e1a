// A map from a bag: of a simulated drive beside the building it went through; of bags that miss something.
#include "components/program/map/map_making.hpp"

#include <filesystem>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <tf2_msgs/msg/tf_message.hpp>
#include <unistd.h>

#include "components/files/map_file.hpp"
#include "components/lab/bench/buildings/building_drive.hpp"
#include "components/lab/bench/buildings/known_map.hpp"
#include "components/lab/bench/slam/map_score.hpp"
#include "components/messages/geometry.hpp"
#include "tests/components/recordings/bags.hpp"

namespace bw {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kStart = 1'700'000'000.0;  // stamps of today [s]

nav_msgs::msg::Odometry message_of(const OdometrySample& sample) {
  nav_msgs::msg::Odometry message;
  message.header(make_header("odom", sample.time + Duration::seconds(kStart)));
  message.child_frame_id("base_link");
  message.pose().pose(to_pose(sample.X_OB));
  return message;
}

sensor_msgs::msg::LaserScan message_of(const ScanSample& sample) {
  sensor_msgs::msg::LaserScan message;
  message.header(make_header(sample.frame, sample.time + Duration::seconds(kStart)));
  message.angle_min(sample.geometry.angle_min);
  message.angle_max(sample.geometry.angle_max);
  message.angle_increment(sample.geometry.angle_increment);
  message.time_increment(sample.geometry.time_increment);
  message.range_min(sample.geometry.range_min);
  message.range_max(sample.geometry.range_max);
  message.ranges(sample.ranges);
  return message;
}

void write_into(TestBag& bag, const RecordedDrive& drive, const std::string& odom, const std::string& scan) {
  tf2_msgs::msg::TFMessage mount;
  mount.transforms().resize(1);
  mount.transforms()[0].header().frame_id("base_link");
  mount.transforms()[0].child_frame_id("laser");
  mount.transforms()[0].transform().rotation().w(1.0);
  bag.add("/tf_static", kStart, mount);
  for (const OdometrySample& sample : drive.odometry)
    bag.add(odom, kStart + sample.time.to_seconds(), message_of(sample));
  for (const ScanSample& sample : drive.scans)
    bag.add(scan, kStart + sample.time.to_seconds(), message_of(sample));
}

void write_bag(const std::filesystem::path& file, const RecordedDrive& drive) {
  TestBag bag(file);
  write_into(bag, drive, "/odom", "/scan");
  bag.close();
}

MadeMap make_of(const std::vector<std::filesystem::path>& files, const MapMakingOptions& options = {},
                const slam::SlamProgress& progress = {}) {
  std::vector<std::unique_ptr<bag::Bag>> recordings;
  std::vector<DriveBag> bags;
  for (const std::filesystem::path& file : files) {
    recordings.push_back(bag::open_bag(file));
    bags.push_back({*recordings.back(), file.string()});
  }
  return make_map(bags, options, progress);
}

class MapMaking : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }

  void write(const RecordedDrive& drive, const std::string& odom = "/odom",
             const std::string& scan = "/scan") {
    write_into(bag_, drive, odom, scan);
  }
  MadeMap make(const MapMakingOptions& options = {}, const slam::SlamProgress& progress = {}) {
    bag_.close();
    return make_of({file_}, options, progress);
  }
  std::string refusal(const MapMakingOptions& options = {}) {
    try {
      make(options);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path file_ = std::filesystem::path(::testing::TempDir()) /
                                ("map_" + std::to_string(getpid()) +
                                 ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".mcap");
  TestBag bag_{file_};
};

buildings::BuildingDriveOptions for_seconds(double seconds) {
  buildings::BuildingDriveOptions options;
  options.longest = Duration::seconds(seconds);
  options.wheels = buildings::calibrated_wheels_of(options.base);
  return options;
}

// Two minutes through an office. What is drawn are its walls: 98 % of the cells have one within a cell. Saved
// and read again it is the same map.
TEST_F(MapMaking, OfASimulatedDriveIsTheBuilding) {
  const buildings::Building office = buildings::make_building(buildings::BuildingKind::office, 1);
  const RecordedDrive drive = buildings::drive_through(office, for_seconds(120.0));
  write(drive);
  const MadeMap map = make();
  EXPECT_EQ(map.scans, drive.scans.size());
  EXPECT_EQ(map.scans_used, drive.scans.size());
  EXPECT_THAT(map.left_out, IsEmpty());
  EXPECT_NEAR(map.seconds, 120.0, 0.2);
  double travel = 0.0;
  for (std::size_t i = 1; i < drive.truth.size(); ++i)
    travel += (drive.truth[i].position - drive.truth[i - 1].position).norm();
  EXPECT_NEAR(map.travel, travel, 0.1 * travel) << "noise of the poses adds to it";
  EXPECT_GT(map.submaps, 5U);
  const Pose2 X_TM{drive.truth.front().position.x(), drive.truth.front().position.y(),
                   *drive.truth.front().heading};
  const slam::MapScore score = slam::score_map(map.grid, buildings::known_map(office), X_TM);
  EXPECT_GT(score.precision(), 0.98);
  EXPECT_GT(map.free_area, 100.0);
  EXPECT_THAT(map_report(map),
              HasSubstr(std::to_string(map.scans) + " of " + std::to_string(map.scans) + " used"));

  const std::filesystem::path yaml = std::filesystem::path(::testing::TempDir()) / "map_making_test.yaml";
  save_map(map.grid, yaml, {});
  EXPECT_EQ(load_map(yaml).cells, map.grid.cells);
}

// Names other than the usual are taken where there is only one, and named where there are several.
TEST_F(MapMaking, FindsTheOnlyTopicOfAType) {
  const RecordedDrive drive = buildings::drive_through(
      buildings::make_building(buildings::BuildingKind::office, 2), for_seconds(5.0));
  write(drive, "/wheel/odom", "/front/scan");
  EXPECT_EQ(make().scans_used, drive.scans.size());
}

TEST_F(MapMaking, AsksWhereThereAreSeveral) {
  const RecordedDrive drive = buildings::drive_through(
      buildings::make_building(buildings::BuildingKind::office, 2), for_seconds(2.0));
  write(drive, "/odom", "/front/scan");
  bag_.add("/rear/scan", kStart, message_of(drive.scans.front()));
  EXPECT_THAT(refusal(),
              HasSubstr("there is no /scan of type sensor_msgs/msg/LaserScan; --scan names one of: "
                        "/front/scan, /rear/scan"));
  EXPECT_EQ(make_of({file_}, {.scans = {"/front/scan"}}).scans_used, drive.scans.size());
  EXPECT_EQ(make_of({file_}, {.scans = {"/front/scan", "/rear/scan"}}).scans, drive.scans.size() + 1);
}

TEST_F(MapMaking, WithoutScansIsRefusedWithTheTopicsThereAre) {
  bag_.add("/odom", kStart, message_of(OdometrySample{}));
  EXPECT_THAT(refusal(),
              HasSubstr(file_.string() + ": no message of type sensor_msgs/msg/LaserScan in it, and there "
                                         "is no map without; its topics: /odom"));
}

TEST_F(MapMaking, WithoutOdometryIsRefused) {
  RecordedDrive drive = buildings::drive_through(buildings::make_building(buildings::BuildingKind::office, 2),
                                                 for_seconds(1.0));
  drive.odometry.clear();
  write(drive);
  EXPECT_THAT(refusal(), HasSubstr("no message of type nav_msgs/msg/Odometry in it"));
}

// The laser runs from the start, odometry from 2 s on: 20 scans are not used, which is said, with when and
// what to do.
TEST_F(MapMaking, TellsWhichScansItLeftOut) {
  RecordedDrive drive = buildings::drive_through(buildings::make_building(buildings::BuildingKind::office, 2),
                                                 for_seconds(5.0));
  std::erase_if(drive.odometry, [](const OdometrySample& s) { return s.time < Time::seconds(2.0); });
  write(drive);
  const MadeMap map = make();
  EXPECT_EQ(map.scans_used, drive.scans.size() - 20U);
  EXPECT_THAT(map.left_out,
              Contains(HasSubstr("20 scans left out: no odometry at their time; first at 0.000 s in frame "
                                 "laser: it begins 2.000 s later")));
}

// Two drives in one office, the second by its own odometry: one map, whose walls are still those of the
// building. A drive in a warehouse has no place in it.
TEST_F(MapMaking, OfTwoDrivesIsOneMap) {
  const buildings::Building office = buildings::make_building(buildings::BuildingKind::office, 1);
  const RecordedDrive drive = buildings::drive_through(office, for_seconds(40.0));
  buildings::BuildingDriveOptions again = for_seconds(80.0);
  again.seed = 2;
  write(drive);
  bag_.close();
  const std::filesystem::path second = file_.string() + ".second.mcap";
  const std::filesystem::path elsewhere = file_.string() + ".elsewhere.mcap";
  write_bag(second, buildings::drive_through(office, again));
  write_bag(elsewhere,
            buildings::drive_through(buildings::make_building(buildings::BuildingKind::warehouse, 1),
                                     for_seconds(5.0)));
  const MadeMap map = make_of({file_, second});
  EXPECT_EQ(map.unplaced, "");
  EXPECT_EQ(map.scans, 401U + 801U);
  EXPECT_GT(map.scans_used, 401U + 600U) << "found within some metres";
  const Pose2 X_TM{drive.truth.front().position.x(), drive.truth.front().position.y(),
                   *drive.truth.front().heading};
  EXPECT_GT(slam::score_map(map.grid, buildings::known_map(office), X_TM).precision(), 0.97);
  EXPECT_EQ(make_of({file_, elsewhere}).unplaced, elsewhere.string());
  for (const auto& file : {second, elsewhere}) std::filesystem::remove(file);
}

TEST_F(MapMaking, EndsWhereItsCallerSays) {
  write(buildings::drive_through(buildings::make_building(buildings::BuildingKind::office, 2),
                                 for_seconds(2.0)));
  const MadeMap map = make({}, [](std::size_t done, std::size_t) { return done < 5; });
  EXPECT_FALSE(map.is_whole);
  EXPECT_EQ(map.scans_used, 5U);
}

}  // namespace
}  // namespace bw
