#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/anchor_range.hpp>
#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/imu.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <sensor_msgs/msg/nav_sat_fix.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/messages/geometry.hpp"
#include "runtime/recording/import/imported_bag.hpp"
#include "tests/components/component_rig.hpp"
#include "tests/components/recordings/bags.hpp"

namespace bw {
namespace {

/// All that a player sends within three seconds.
struct Heard {
  std::vector<nav_msgs::msg::Odometry> odometry;
  std::vector<tf2_msgs::msg::TFMessage> tf;
  std::vector<tf2_msgs::msg::TFMessage> mounts;
  std::vector<sensor_msgs::msg::Imu> imu;
  std::vector<sensor_msgs::msg::NavSatFix> fixes;
  std::vector<sensor_msgs::msg::NavSatFix> held_out;
  std::vector<bandwagon_msgs::msg::AnchorRange> ranges;
  std::vector<sensor_msgs::msg::LaserScan> scans;
  std::vector<bandwagon_msgs::msg::GroundTruth> truth;
};

template <class M>
void keep(Setup& setup, const std::string& topic, std::vector<M>& list) {
  setup.input<M>(
      topic, Qos::standard(1000), [&list](const auto& m, const Tick&) { list.push_back(m); }, Need::optional);
}

double seconds_of(const std_msgs::msg::Header& header) {
  return seconds_since_start(from_stamp(header.stamp()));
}

class RecordedRobot : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) /
              (std::string("log_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }

  void write_husky() {
    write("wheel_odom.csv",
          "t_s,x_m,y_m,yaw_rad,v_mps,omega_radps\n0.5,8,1,0,0.5,0\n1.0,8.25,1,0,0.5,0.25\n"
          "1.5,8.5,1,0.3,0.5,0.25\n");
    write("imu.csv",
          "t_s,qx,qy,qz,qw,yaw_rad,wx_radps,wy_radps,wz_radps,ax_mps2,ay_mps2,az_mps2,base_yaw_rad,"
          "base_wz_radps\n1.25,0,0,0,1,0,0,0,0,0,0,0,-0.25,0.5\n");
    write("gps.csv",
          "t_s,status,lat_deg,lon_deg,alt_m,var_e_m2,var_n_m2,var_u_m2\n0.75,1,42.5,-71.25,7,0.81,0.64,3\n"
          "1.125,1,42.5,-71.25,8,0.81,0.64,3\n");
  }

  /// Makes a bag of the folder's tables by a columns file of config/imports, and plays it.
  Heard play(const std::string& log, const std::string& parameters = "") {
    return play_by(std::string(BANDWAGON_SOURCE_DIR) + "/config/imports/" + log + ".yaml", parameters);
  }
  Heard play_by(const std::filesystem::path& columns, const std::string& parameters) {
    const std::filesystem::path bag = folder_ / "log.mcap";
    imports::write_bag(imports::import_tables(imports::read_columns_file(columns), {folder_}), bag);
    return play_bag(bag, parameters);
  }
  static Heard play_bag(const std::filesystem::path& bag, const std::string& parameters) {
    Heard heard;
    const std::string yaml = "components: {recorded_robot: {parameters: {bag: " + bag.string() +
                             (parameters.empty() ? "" : ", ") + parameters + "}}}";
    run_with_script(yaml, 3.0, [&heard](bw::Setup& setup) {
      keep(setup, "odom", heard.odometry);
      keep(setup, "imu", heard.imu);
      keep(setup, "gps/fix", heard.fixes);
      keep(setup, "gps/fix_held_out", heard.held_out);
      keep(setup, "ranges", heard.ranges);
      keep(setup, "scan", heard.scans);
      keep(setup, "sim/ground_truth", heard.truth);
      setup.input<tf2_msgs::msg::TFMessage>(
          "/tf_static", Qos::tf_static(), [&heard](const auto& m, const Tick&) { heard.mounts.push_back(m); },
          Need::optional);
      setup.input<tf2_msgs::msg::TFMessage>("/tf", Qos::tf(),
                                            [&heard](const auto& m, const Tick&) { heard.tf.push_back(m); });
    });
    return heard;
  }

  std::filesystem::path folder_;
};

TEST_F(RecordedRobot, PlaysAHuskyLogAtItsOwnStamps) {
  write_husky();
  const Heard heard = play("husky", "start: 0.25");
  ASSERT_EQ(heard.odometry.size(), 3U);
  EXPECT_NEAR(seconds_of(heard.odometry[1].header()), 0.75, 1e-9);
  EXPECT_EQ(heard.odometry[1].header().frame_id(), "odom");
  EXPECT_EQ(heard.odometry[1].child_frame_id(), "base_link");
  EXPECT_EQ(heard.odometry[1].pose().pose().position().x(), 8.25);
  EXPECT_EQ(heard.odometry[1].twist().twist().angular().z(), 0.25);
  // k = 0.0005 per metre of either wheel over 0.25 m straight on: (0.25 + 0.25) k / 4 along the path; across
  // it the rotation's, (0.25 + 0.25) k / b^2, at half the distance.
  EXPECT_NEAR(heard.odometry[1].pose().covariance()[0], 0.0005 * 0.5 / 4.0, 1e-9);
  EXPECT_NEAR(heard.odometry[1].pose().covariance()[7], 0.125 * 0.125 * 0.0005 * 0.5 / (0.5708 * 0.5708),
              1e-9);
  ASSERT_EQ(heard.tf.size(), 3U);
  EXPECT_EQ(heard.tf[2].transforms().at(0).transform().translation().x(), 8.5);
  ASSERT_EQ(heard.imu.size(), 1U);
  EXPECT_NEAR(seconds_of(heard.imu[0].header()), 1.0, 1e-9);
  EXPECT_NEAR(yaw_of(heard.imu[0].orientation()), -0.25, 1e-12);
  EXPECT_EQ(heard.imu[0].angular_velocity().z(), 0.5);
  ASSERT_EQ(heard.fixes.size(), 2U);
  EXPECT_EQ(heard.fixes[0].latitude(), 42.5);
  EXPECT_EQ(heard.fixes[0].position_covariance()[4], 0.64);
  EXPECT_TRUE(heard.truth.empty());
}

TEST_F(RecordedRobot, HoldsFixesOutAndStopsAtTheEnd) {
  write_husky();
  const Heard heard = play("husky", "end: 1.2, hold_out: {rule: every_second}");
  EXPECT_EQ(heard.odometry.size(), 2U);
  ASSERT_EQ(heard.fixes.size(), 1U);
  EXPECT_EQ(heard.fixes[0].altitude(), 7.0);
  ASSERT_EQ(heard.held_out.size(), 1U);
  EXPECT_EQ(heard.held_out[0].altitude(), 8.0);
  EXPECT_NEAR(seconds_of(heard.held_out[0].header()), 1.125, 1e-9);
}

// Twice as fast: half the time, twice the speeds, the same path.
TEST_F(RecordedRobot, PlaysFaster) {
  write_husky();
  const Heard heard = play("husky", "rate: 2");
  ASSERT_EQ(heard.odometry.size(), 3U);
  EXPECT_NEAR(seconds_of(heard.odometry[2].header()), 0.75, 1e-9);
  EXPECT_EQ(heard.odometry[2].twist().twist().linear().x(), 1.0);
  EXPECT_EQ(heard.odometry[2].pose().pose().position().x(), 8.5);
  EXPECT_EQ(heard.imu.at(0).angular_velocity().z(), 1.0);
}

// Truth drives 1 m/s along y: heading pi/2, one fix a second, ten headings.
TEST_F(RecordedRobot, MakesReceiverAndCompassFromTheReference) {
  std::string truth = "t_s,x_m,y_m,yaw_rad\n";
  for (int i = 0; i <= 25; ++i)
    truth += std::to_string(i / 10.0) + ",3," + std::to_string(i / 10.0) + ",1.570796\n";
  write("groundtruth_10hz.csv", truth);
  write("odometry.csv", "t_s,v_mps,omega_radps\n0,1,0\n2.5,0,0\n");
  const Heard heard =
      play("mrclam", "make_sensors: true, synthetic: {gps_noise: 0.001, compass_noise: 0.001}");
  EXPECT_EQ(heard.odometry.size(), 26U);  // at least every 0.1 s
  ASSERT_EQ(heard.fixes.size(), 2U);
  EXPECT_NEAR(heard.fixes[0].latitude(), 21.0 + 1.0 / 110'717.0, 1e-7);  // metres a degree of latitude there
  ASSERT_EQ(heard.imu.size(), 25U);
  EXPECT_NEAR(yaw_of(heard.imu[3].orientation()), 1.5708, 0.005);
  EXPECT_EQ(heard.imu[3].angular_velocity_covariance()[0], -1.0);  // no gyro
  EXPECT_DOUBLE_EQ(heard.imu[3].orientation_covariance()[8], 1e-6);
  ASSERT_EQ(heard.truth.size(), 26U);
  EXPECT_NEAR(heard.truth[5].twist().linear().x(), 1.0, 1e-6);
  EXPECT_EQ(heard.truth[5].pose().position().x(), 3.0);
}

TEST_F(RecordedRobot, PlaysRangesAndAReferenceWithoutHeading) {
  write("Indoor_UWB_Input.txt",
        "range2 0.1 1.5 0.01 0.5 2 105 0 \nodom2diff 0.1 0 0 0 0.05 1e-4 1e-4 1e-4\n");
  write("Indoor_UWB_GT.txt", "point2 0.1 1.5 2.5 0 0 0 0 \n");
  const Heard heard = play("labyrinth");
  ASSERT_EQ(heard.ranges.size(), 1U);
  EXPECT_EQ(heard.ranges[0].header().frame_id(), "map");
  EXPECT_EQ(heard.ranges[0].anchor().y(), 2.0);
  EXPECT_EQ(heard.ranges[0].range(), 1.5);
  EXPECT_EQ(heard.ranges[0].variance(), 0.01);
  ASSERT_EQ(heard.truth.size(), 1U);
  EXPECT_TRUE(std::isnan(yaw_of(heard.truth[0].pose().orientation())));
  EXPECT_TRUE(std::isnan(heard.truth[0].twist().linear().x()));
}

TEST_F(RecordedRobot, PlaysScansOfAStandingRobot) {
  std::string text = "t_s";
  for (int beam = 0; beam < 512; ++beam) text += ",r" + std::to_string(beam);
  text += "\n0.2";
  for (int beam = 0; beam < 512; ++beam) text += beam == 1 ? ",inf" : ",2.5";
  write("scans.csv", text + "\n");
  const Heard heard = play("laser");
  ASSERT_EQ(heard.scans.size(), 1U);
  EXPECT_EQ(heard.scans[0].header().frame_id(), "laser");
  ASSERT_EQ(heard.scans[0].ranges().size(), 512U);
  EXPECT_TRUE(std::isinf(heard.scans[0].ranges()[1]));
  EXPECT_NEAR(heard.scans[0].angle_max(), -1.570796 + 511 * 0.006135923, 1e-5);
  ASSERT_EQ(heard.odometry.size(), 1U);
  EXPECT_EQ(heard.odometry[0].twist().twist().linear().x(), 0.0);
}

// A scanner all around, 1081 beams over 360 degrees, an empty cell where nothing was measured: what the
// columns file says of it arrives, whatever other scanners have.
TEST_F(RecordedRobot, PlaysAScannerOf1081BeamsWithGaps) {
  std::string text;
  for (int k = 1; k <= 4; ++k) {
    text += std::to_string(k * 250);
    for (int beam = 0; beam < 1081; ++beam) text += beam % 7 == 2 ? "," : "," + std::to_string(500 + beam);
    text += "\n";
  }
  write("around.csv", text);
  write("around.yaml", R"(
tables:
  - file: around.csv
    columns: [ms, "r[1081]"]
    stamp: {column: ms, unit: ms}
    messages:
      - topic: /top/scan
        type: sensor_msgs/msg/LaserScan
        fields:
          ranges: {columns: r, unit: mm, gaps: {"": nan}}
        constants: {header.frame_id: top, angle_min: -180 deg, angle_max: 180 deg, range_min: 0.05, range_max: 30}
)");
  const Heard heard = play_by(folder_ / "around.yaml", "topics: {scans: [/top/scan]}");
  ASSERT_EQ(heard.scans.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    const sensor_msgs::msg::LaserScan& scan = heard.scans[k];
    EXPECT_NEAR(seconds_of(scan.header()), 0.25 * static_cast<double>(k), 1e-9);  // from the first stamp
    EXPECT_EQ(scan.header().frame_id(), "top");
    ASSERT_EQ(scan.ranges().size(), 1081U);
    EXPECT_FLOAT_EQ(scan.angle_increment(), static_cast<float>(std::numbers::pi / 540.0));
    for (std::size_t beam = 0; beam < 1081; ++beam) {
      if (beam % 7 == 2) {
        EXPECT_TRUE(std::isnan(scan.ranges()[beam]));
      } else {
        EXPECT_FLOAT_EQ(scan.ranges()[beam], 0.5F + 0.001F * static_cast<float>(beam));
      }
    }
  }
}

// Another robot's bag, with stamps of today and its scanner's position in /tf_static; where the base is,
// others say.
TEST_F(RecordedRobot, PlaysTheBagOfAnyRobot) {
  const std::filesystem::path file = folder_ / "robot.mcap";
  TestBag bag(file);
  tf2_msgs::msg::TFMessage mounts;
  mounts.transforms().push_back(to_transform("base_footprint", "base_link", Time{}, {}));
  mounts.transforms().push_back(to_transform("base_link", "lidar", Time{}, {0.25, 0.0, 0.5}));
  bag.add("/tf_static", 1'700'000'000.0, mounts);
  nav_msgs::msg::Odometry odometry;
  for (int i = 0; i < 3; ++i) {
    odometry.header(make_header("odom", Time::seconds(1'700'000'000.5 + 0.5 * i)));
    odometry.pose().pose(to_pose({1.0 * i, 2.0, 0.25}));
    bag.add("/odom", 1'700'000'000.5 + 0.5 * i, odometry);
  }
  sensor_msgs::msg::LaserScan scan;
  scan.header(make_header("lidar", Time::seconds(1'700'000'001.0)));
  scan.ranges({1.0F, 2.0F});
  bag.add("/scan", 1'700'000'001.25, scan);
  bag.close();
  const Heard heard = play_bag(file, "");
  ASSERT_EQ(heard.odometry.size(), 3U);
  EXPECT_NEAR(seconds_of(heard.odometry[2].header()), 1.0, 1e-9);
  EXPECT_EQ(heard.odometry[2].pose().pose().position().x(), 2.0);
  ASSERT_EQ(heard.scans.size(), 1U);
  EXPECT_EQ(heard.scans[0].header().frame_id(), "lidar");
  EXPECT_NEAR(seconds_of(heard.scans[0].header()), 0.5, 1e-9);
  ASSERT_EQ(heard.mounts.size(), 1U);
  ASSERT_EQ(heard.mounts[0].transforms().size(), 1U);
  EXPECT_EQ(heard.mounts[0].transforms()[0].child_frame_id(), "lidar");
  EXPECT_EQ(heard.mounts[0].transforms()[0].transform().translation().x(), 0.25);
}

TEST_F(RecordedRobot, EndsTheRunASecondAfterTheBagUnlessToldOtherwise) {
  for (const bool ends : {true, false}) {
    write_husky();
    const auto file = folder_ / "log.mcap";
    std::filesystem::remove(file);
    imports::write_bag(imports::import_tables(imports::read_columns_file(std::string(BANDWAGON_SOURCE_DIR) +
                                                                         "/config/imports/husky.yaml"),
                                              {folder_}),
                       file);
    double last = 0.0;
    run_with_script("components: {recorded_robot: {parameters: {bag: " + file.string() +
                        ", end_run: " + (ends ? "true" : "false") + "}}}",
                    5.0, [&last](bw::Setup& setup) {
                      setup.every(Duration::milliseconds(10), "look",
                                  [&last](const Tick& tick) { last = seconds_since_start(tick.now); });
                    });
    EXPECT_NEAR(last, ends ? 2.5 : 5.0, 0.02);  // the last entry is of 1.5 s
  }
}

std::string said_by(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST_F(RecordedRobot, SaysWhatIsWrongWithABag) {
  EXPECT_THAT(said_by([&] { play_bag(folder_ / "none.mcap", ""); }), testing::HasSubstr("none.mcap"));
  write_husky();
  EXPECT_THAT(said_by([&] { play("husky", "topics: {imu: /gps/fix}"); }),
              testing::HasSubstr(
                  "log.mcap: /gps/fix is sensor_msgs/msg/NavSatFix, and sensor_msgs/msg/Imu is needed"));
}

}  // namespace
}  // namespace bw
