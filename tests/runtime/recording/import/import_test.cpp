// Two logs made up here, imported by their columns files alone, with what they must give in closed form; and
// what becomes of gaps, stamps and lines.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/imu.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <sensor_msgs/msg/nav_sat_fix.hpp>

#include "runtime/recording/bag/log_record.hpp"
#include "tests/runtime/recording/import/tables.hpp"

namespace bw::imports {
namespace {

using nav_msgs::msg::Odometry;
using sensor_msgs::msg::LaserScan;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kDegree = std::numbers::pi / 180.0;

double yaw_of(const geometry_msgs::msg::Quaternion& q) {
  return std::atan2(2.0 * (q.w() * q.z() + q.x() * q.y()), 1.0 - 2.0 * (q.y() * q.y() + q.z() * q.z()));
}

constexpr const char* kShip = R"(
log: {name: ship, source: made up, licence: none, parameters: {wheel_separation: 0.4}}
tables:
  - file: ship.csv
    separator: semicolon
    header: true
    stamp: {column: time, unit: us, offset: 1700000000}
    messages:
      - topic: /odom
        type: nav_msgs/msg/Odometry
        fields:
          pose.pose.position.x: {column: east, unit: mm}
          pose.pose.position.y: {column: north, unit: mm}
          pose.pose.orientation.yaw: {column: compass, unit: deg, turning: clockwise, zero: north}
          pose.covariance[35]: {column: compass_sd, unit: deg, sigma: true}
          twist.twist.linear.x: {column: speed, unit: km/h}
          twist.twist.angular.z: {column: turn, unit: deg/s, turning: clockwise}
        constants:
          header.frame_id: odom
          child_frame_id: base_link
          pose.covariance[0]: {value: 3, unit: cm, sigma: true}
          pose.covariance[7]: 0.25
)";

// A circle of 2 m at 3.6 km/h, to the right: heading by compass 90 + 90 t / pi degrees, so that a quarter
// takes pi s.
TEST(Import, CompassDegreesMillimetresKilometresPerHourAndMicroseconds) {
  const Tables tables;
  std::string text = "time;north;east;compass;compass_sd;speed;turn\n";
  for (int i = 0; i <= 20; ++i) {
    const double t = 0.1 * i;
    const double heading = t / 2.0;  // [rad]
    text += fmt::format("{};{};{};{};{};{};{}\n", 100'000 * i, -2000.0 * (1.0 - std::cos(heading)),
                        2000.0 * std::sin(heading), 90.0 + heading / kDegree, 2.0, 3.6, 0.5 / kDegree);
  }
  tables.write("ship.csv", text);
  const ImportedLog log = tables.import(kShip);
  ASSERT_EQ(log.messages.size(), 21U);
  const std::vector<Odometry> odometry = messages_of<Odometry>(log, "/odom");
  for (int i = 0; i <= 20; ++i) {
    const Odometry& o = odometry[static_cast<std::size_t>(i)];
    const double heading = 0.05 * i;
    EXPECT_EQ(log.messages[static_cast<std::size_t>(i)].stamp.nanoseconds,
              1'700'000'000'000'000'000 + 100'000'000 * i);
    EXPECT_EQ(o.header().stamp().sec(), 1'700'000'000 + i / 10);
    EXPECT_EQ(o.header().stamp().nanosec(), 100'000'000U * static_cast<unsigned>(i % 10));
    EXPECT_NEAR(o.pose().pose().position().x(), 2.0 * std::sin(heading), 1e-12);
    EXPECT_NEAR(o.pose().pose().position().y(), -2.0 * (1.0 - std::cos(heading)), 1e-12);
    EXPECT_NEAR(yaw_of(o.pose().pose().orientation()), -heading, 1e-12);
    EXPECT_NEAR(o.twist().twist().linear().x(), 1.0, 1e-12);
    EXPECT_NEAR(o.twist().twist().angular().z(), -0.5, 1e-12);
    EXPECT_NEAR(o.pose().covariance()[0], 0.0009, 1e-15);
    EXPECT_EQ(o.pose().covariance()[7], 0.25);
    EXPECT_NEAR(o.pose().covariance()[35], std::pow(2.0 * kDegree, 2), 1e-15);
    EXPECT_EQ(o.header().frame_id(), "odom");
    EXPECT_EQ(o.child_frame_id(), "base_link");
  }
  const auto& record = log.metadata.at(bag::kLogRecord);
  EXPECT_EQ(record.at("name"), "ship");
  EXPECT_EQ(record.at("source"), "made up");
  EXPECT_EQ(record.at("tables"), "ship.csv");
  EXPECT_EQ(record.at("wheel_separation"), "0.4");
}

// 1081 beams all around, 360 degrees over 1080 steps, the last beam looking where the first does; ranges in
// millimetres, an empty cell where nothing was measured, 0 where nothing came back.
TEST(Import, AScannerAllAroundWithGaps) {
  constexpr int kBeams = 1081;
  const Tables tables;
  std::string text;
  for (int k = 0; k < 5; ++k) {
    text += fmt::format("{}", 250 * k);
    for (int beam = 0; beam < kBeams; ++beam)
      text += beam % 10 == 3 ? "," : beam % 10 == 4 ? ",0.00" : fmt::format(",{}", 1000 + beam);
    text += "\n";
  }
  tables.write("around.csv", text);
  const ImportedLog log = tables.import(R"(
tables:
  - file: around.csv
    columns: [ms, "r[*]"]
    stamp: {column: ms, unit: ms}
    messages:
      - topic: /scan
        type: sensor_msgs/msg/LaserScan
        fields:
          ranges: {columns: r, unit: mm, gaps: {"": nan, "0": inf}}
        constants: {header.frame_id: top, angle_min: -180 deg, angle_max: 180 deg, scan_time: 250 ms, range_min: 0.05, range_max: 30}
)");
  const std::vector<LaserScan> scans = messages_of<LaserScan>(log, "/scan");
  ASSERT_EQ(scans.size(), 5U);
  for (const LaserScan& scan : scans) {
    ASSERT_EQ(scan.ranges().size(), 1081U);
    EXPECT_FLOAT_EQ(scan.angle_min(), static_cast<float>(-std::numbers::pi));
    EXPECT_FLOAT_EQ(scan.angle_increment(), static_cast<float>(2.0 * std::numbers::pi / 1080.0));
    EXPECT_FLOAT_EQ(scan.angle_max(), static_cast<float>(std::numbers::pi));
    EXPECT_EQ(scan.scan_time(), 0.25F);
    for (std::size_t beam = 0; beam < scan.ranges().size(); ++beam) {
      if (beam % 10 == 3) {
        EXPECT_TRUE(std::isnan(scan.ranges()[beam])) << beam;
      } else if (beam % 10 == 4) {
        EXPECT_EQ(scan.ranges()[beam], std::numeric_limits<float>::infinity()) << beam;
      } else {
        EXPECT_FLOAT_EQ(scan.ranges()[beam], 1.0F + 0.001F * static_cast<float>(beam)) << beam;
      }
    }
  }
  EXPECT_EQ(scans[4].header().stamp().sec(), 1);
}

// The form of CARMEN: the count tells where the rest begins. 180 ranges look from -90 to 89 degrees, 361 from
// -90 to 90.
TEST(Import, LinesWithAWordACountAndThatManyRanges) {
  const Tables tables;
  const auto flaser = [](int n, double range, const std::string& time) {
    std::string line = "FLASER " + std::to_string(n);
    for (int i = 0; i < n; ++i) line += fmt::format(" {:.2f}", i == 1 ? 81.83 : range);
    return line + " 1.5 2.5 0.25 1.0 2.0 0.5 " + time + " nohost " + time + "\n";
  };
  const auto log_file = tables.write(
      "robot.log", "# a log\nPARAM robot_width 0.4\nODOM 1 2 1.5707963 0.3 -0.1 0 976052890.25 nohost 0.5\n" +
                       flaser(180, 2.0, "976052890.5") + flaser(361, 3.0, "976052890.75") +
                       "ODOM 1 2 1.5707963 0.3 -0.1 0 976052890.25 nohost 0.5\n");
  const ImportedLog log =
      import_tables(read_columns_file(BANDWAGON_SOURCE_DIR "/config/imports/carmen.yaml"), {log_file});
  const auto scans = messages_of<LaserScan>(log, "/scan");
  ASSERT_EQ(scans.size(), 2U);
  EXPECT_EQ(scans[0].ranges().size(), 180U);
  EXPECT_EQ(scans[0].ranges()[1], std::numeric_limits<float>::infinity());
  EXPECT_EQ(scans[0].ranges()[179], 2.0F);
  EXPECT_FLOAT_EQ(scans[0].angle_max(), static_cast<float>(89.0 * kDegree));
  EXPECT_EQ(scans[1].ranges().size(), 361U);
  EXPECT_FLOAT_EQ(scans[1].angle_max(), static_cast<float>(90.0 * kDegree));
  EXPECT_FLOAT_EQ(scans[1].angle_increment(), static_cast<float>(0.5 * kDegree));
  EXPECT_EQ(scans[1].header().stamp().nanosec(), 750'000'000U);
  const auto odometry = messages_of<Odometry>(log, "/odom");
  ASSERT_EQ(odometry.size(), 1U);  // the second has the stamp of the first
  EXPECT_EQ(odometry[0].header().stamp().sec(), 976'052'890);
  EXPECT_NEAR(yaw_of(odometry[0].pose().pose().orientation()), 1.5707963, 1e-12);
  EXPECT_EQ(odometry[0].twist().twist().linear().x(), 0.3);
  EXPECT_EQ(log.report.at(0).counts.duplicate_stamps, 1U);

  const auto other = tables.write("other.log", flaser(270, 2.0, "976052890.5"));
  try {
    import_tables(read_columns_file(BANDWAGON_SOURCE_DIR "/config/imports/carmen.yaml"), {other});
    FAIL();
  } catch (const TableError& error) {
    EXPECT_THAT(error.what(), HasSubstr("other.log:1: 270 cells of 'ranges'"));
    EXPECT_THAT(error.what(), HasSubstr("gives angle_min no value for this count"));
  }
}

std::string stamped(const std::string& duplicate, const std::string& falling) {
  return "tables:\n  - file: a.csv\n    columns: [t, x]\n    stamp: {column: t, on_duplicate: " + duplicate +
         ", on_falling: " + falling +
         "}\n    messages:\n      - topic: /odom\n        type: nav_msgs/msg/Odometry\n"
         "        fields: {pose.pose.position.x: x}\n";
}

std::vector<double> positions(const ImportedLog& log) {
  std::vector<double> list;
  for (const Odometry& o : messages_of<Odometry>(log, "/odom"))
    list.push_back(o.pose().pose().position().x());
  return list;
}

TEST(Import, DuplicateAndFallingStampsAreDroppedKeptOrRefusedAndCounted) {
  const Tables tables;
  tables.write("a.csv", "1,1\n2,2\n2,3\n1.5,4\n3,5\n");
  const ImportedLog dropped = tables.import(stamped("drop", "drop"));
  EXPECT_THAT(positions(dropped), ElementsAre(1, 2, 5));
  EXPECT_EQ(dropped.report.at(0).counts.duplicate_stamps, 1U);
  EXPECT_EQ(dropped.report.at(0).counts.falling_stamps, 1U);
  EXPECT_EQ(dropped.report.at(0).counts.rows, 5U);
  EXPECT_EQ(dropped.report.at(0).counts.messages, 3U);
  EXPECT_THAT(positions(tables.import(stamped("keep", "keep"))),
              ElementsAre(1, 4, 2, 3, 5));  // in order of time
  EXPECT_THAT(tables.refusal(stamped("refuse", "drop")),
              HasSubstr("a.csv:3: column 1 (t) = '2': is the stamp of the row before"));
  EXPECT_THAT(tables.refusal(stamped("drop", "refuse")),
              HasSubstr("a.csv:4: column 1 (t) = '1.5': is before the stamp"));
}

TEST(Import, TablesAreMergedInOrderOfTime) {
  const Tables tables;
  tables.write("a.csv", "1,1\n3,3\n");
  tables.write("b.txt", "fix 2 47.5\nfix 3 47.25\nfix 4 -\n");
  const ImportedLog log = tables.import(stamped("refuse", "refuse") + R"(
  - file: "?.txt"
    separator: whitespace
    columns: [word, t, lat]
    stamp: {column: t}
    messages:
      - line: fix
        topic: /fix
        type: sensor_msgs/NavSatFix
        fields: {latitude: {column: lat, gaps: {"-": skip}}}
)");
  std::string order;
  for (const ImportedMessage& m : log.messages) order += log.topics[m.topic].name + " ";
  EXPECT_EQ(order, "/odom /fix /odom /fix ");  // at 3 s in the order of the columns file
  EXPECT_EQ(log.topics[1].type, "sensor_msgs/msg/NavSatFix");
  EXPECT_EQ(log.topics[1].message_count, 2U);
  EXPECT_EQ(log.report.at(1).counts.skipped, 1U);
}

TEST(Import, SecondsAndNanosecondsInTwoColumnsAndBeamsInReverse) {
  const Tables tables;
  tables.write("a.csv", "sec,nsec,r0,r1,r2\n1700000000,5,1,2,3\n");
  const ImportedLog log = tables.import(R"(
tables:
  - file: a.csv
    header: true
    stamp: {column: sec, nanoseconds: nsec}
    messages:
      - topic: /scan
        type: sensor_msgs/msg/LaserScan
        fields:
          ranges: {columns: 3..5, reverse: true}
)");
  EXPECT_EQ(log.messages.at(0).stamp.nanoseconds, 1'700'000'000'000'000'005);
  EXPECT_THAT(messages_of<LaserScan>(log, "/scan").at(0).ranges(), ElementsAre(3.0F, 2.0F, 1.0F));
}

TEST(Import, TextsTruthValuesAndTimesOfOtherFields) {
  const Tables tables;
  tables.write("a.csv", "1,front,7.25,40\n");
  const ImportedLog log = tables.import(R"(
tables:
  - file: a.csv
    columns: [t, frame, sensed, cm]
    stamp: {column: t}
    messages:
      - topic: /odom
        type: nav_msgs/msg/Odometry
        fields: {header.frame_id: frame, pose.pose.position.x: 4}
        constants: {twist.covariance: 0.5}
)");
  const Odometry odometry = messages_of<Odometry>(log, "/odom").at(0);
  EXPECT_EQ(odometry.header().frame_id(), "front");
  EXPECT_EQ(odometry.pose().pose().position().x(), 40.0);
  EXPECT_THAT(odometry.twist().covariance(), testing::Each(0.5));
}

/// What stands between ``` and ``` in a page.
std::vector<std::string> blocks_of(const std::filesystem::path& page) {
  std::ifstream file(page);
  std::vector<std::string> blocks;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("```")) {
      inside = !inside;
      if (inside) blocks.emplace_back();
    } else if (inside) {
      blocks.back() += line + "\n";
    }
  }
  return blocks;
}

TEST(Import, TheExampleOfTheReadmeIsImported) {
  const Tables tables;
  const std::vector<std::string> blocks = blocks_of(BANDWAGON_SOURCE_DIR "/config/imports/README.md");
  ASSERT_EQ(blocks.size(), 4U);  // the command, two tables, the columns file
  tables.write("boat.csv", blocks[1]);
  tables.write("scans.txt", blocks[2]);
  const ImportedLog log = tables.import(blocks[3]);
  const auto odometry = messages_of<Odometry>(log, "/odom");
  ASSERT_EQ(odometry.size(), 2U);
  EXPECT_NEAR(odometry[0].twist().twist().linear().x(), 1.0, 1e-12);
  EXPECT_NEAR(yaw_of(odometry[1].pose().pose().orientation()), -0.5 * kDegree, 1e-12);
  const LaserScan scan = messages_of<LaserScan>(log, "/scan").at(0);
  ASSERT_EQ(scan.ranges().size(), 4U);
  EXPECT_FLOAT_EQ(scan.ranges()[0], 1.53F);
  EXPECT_EQ(scan.ranges()[1], std::numeric_limits<float>::infinity());
  EXPECT_TRUE(std::isnan(scan.ranges()[3]));
  EXPECT_FLOAT_EQ(scan.angle_increment(), static_cast<float>(60.0 * kDegree));
}

}  // namespace
}  // namespace bw::imports
