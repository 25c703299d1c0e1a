// The logs that config/imports describes, as drives: what the columns files make of a few lines, and the
// recorded logs whole.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/recordings/files/imported_drive.hpp"

namespace bw {
namespace {

using ::testing::HasSubstr;

RecordedDrive read_log(const std::string& name, const std::filesystem::path& folder) {
  return import_drive(std::string(BANDWAGON_SOURCE_DIR) + "/config/imports/" + name + ".yaml", {folder})
      .drive;
}

class ImportedLogs : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) /
              ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }

  /// What the import says of the folder; empty when it reads it.
  std::string complaint(const std::string& log) {
    try {
      read_log(log, folder_);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path folder_;
};

constexpr const char* kHuskyWheels = "t_s,x_m,y_m,yaw_rad,v_mps,omega_radps\n";
constexpr const char* kHuskyImu =
    "t_s,qx,qy,qz,qw,yaw_rad,wx_radps,wy_radps,wz_radps,ax_mps2,ay_mps2,az_mps2,base_yaw_rad,base_wz_radps\n";
constexpr const char* kHuskyFixes = "t_s,status,lat_deg,lon_deg,alt_m,var_e_m2,var_n_m2,var_u_m2\n";

TEST_F(ImportedLogs, HuskyIsReadAsWritten) {
  write("wheel_odom.csv", std::string(kHuskyWheels) + "0.5,1,2,7,0.25,-0.5\n0.6,1,2,0.1,0.25,-0.5\n");
  write("imu.csv", std::string(kHuskyImu) + "0.25,0,0,0,1,9,9,9,9,9,9,9,-0.2,0.03\n");
  write("gps.csv", std::string(kHuskyFixes) + "1,-1,0,0,0,1,1,1\n2,1,42.5,-71.25,7,0.81,0.64,3\n");
  const RecordedDrive drive = read_log("husky", folder_);
  ASSERT_EQ(drive.odometry.size(), 2U);
  EXPECT_EQ(drive.odometry[0].time, Time::seconds(0.5));
  EXPECT_EQ(drive.odometry[0].X_OB.y, 2.0);
  EXPECT_NEAR(drive.odometry[0].X_OB.theta, wrap_angle(7.0), 1e-12);
  EXPECT_EQ(drive.odometry[0].twist, (Twist2{0.25, -0.5}));
  ASSERT_EQ(drive.imu.size(), 1U);
  EXPECT_NEAR(*drive.imu[0].heading, -0.2, 1e-12);
  EXPECT_EQ(*drive.imu[0].turn_rate, 0.03);
  EXPECT_EQ(drive.imu[0].heading_variance, 0.0);
  ASSERT_EQ(drive.fixes.size(), 1U);  // status -1 is no fix
  EXPECT_EQ(drive.fixes[0].position.longitude, -71.25);
  EXPECT_EQ(drive.fixes[0].variance, Eigen::Vector3d(0.81, 0.64, 3.0));
  EXPECT_EQ(drive.datum.latitude, 42.5);
  EXPECT_EQ(drive.wheel_separation, 0.5708);
}

TEST_F(ImportedLogs, HuskyFaultsAreRefusedWithFileLineAndColumn) {
  write("wheel_odom.csv", kHuskyWheels);
  write("imu.csv", kHuskyImu);
  EXPECT_THAT(complaint("husky"), HasSubstr("tables.2.file = gps.csv: no table of this name is given"));
  write("gps.csv", "t_s,lat_deg,lon_deg,alt_m,var_e_m2,var_n_m2,var_u_m2\n");
  EXPECT_THAT(complaint("husky"), HasSubstr("fields.status.status = status: unknown column"));
  write("gps.csv", std::string(kHuskyFixes) + "1,1,42,-71,0,1,1,1\n2,1,92,-71,0,1,1,1\n");
  EXPECT_THAT(complaint("husky"),
              HasSubstr("gps.csv:3: column 3 (lat_deg) = '92': must be between -90 and 90"));
  write("gps.csv", std::string(kHuskyFixes) + "1,1,42,-71,0,0,1,1\n");
  EXPECT_THAT(complaint("husky"), HasSubstr("gps.csv:2: column 6 (var_e_m2) = '0'"));
  write("gps.csv", std::string(kHuskyFixes) + "1,1,42,-71,0,1,1\n");
  EXPECT_THAT(complaint("husky"), HasSubstr("gps.csv:2: 7 cells where 8 are expected"));
  write("gps.csv", kHuskyFixes);
  write("wheel_odom.csv", std::string(kHuskyWheels) + "1,0,0,0,0,0\n2,0,0,nan,0,0\n");
  EXPECT_THAT(complaint("husky"),
              HasSubstr("wheel_odom.csv:3: column 4 (yaw_rad) = 'nan': is no finite number"));
  write("wheel_odom.csv", std::string(kHuskyWheels) + "1,0,0,0,0,0\n0.9,0,0,0,0,0\n");
  EXPECT_THAT(complaint("husky"), HasSubstr("wheel_odom.csv:3: column 1 (t_s) = '0.9': is before the stamp"));
  write("wheel_odom.csv", std::string(kHuskyWheels) + "1e300,0,0,0,0,0\n");
  EXPECT_THAT(complaint("husky"), HasSubstr("wheel_odom.csv:2: column 1 (t_s) = '1e300': is no stamp"));
}

// Commands held: 0.4 m/s for 0.25 s (0.1 m), then pi/2 rad/s for 0.1 s.
TEST_F(ImportedLogs, MrclamHoldsEachCommandUntilTheNext) {
  write("odometry.csv", "t_s,v_mps,omega_radps\n1,0.4,0\n1.25,0,1.570796\n1.35,0,0\n");
  write("groundtruth_10hz.csv", "t_s,x_m,y_m,yaw_rad\n0,1,2,3\n");
  const RecordedDrive drive = read_log("mrclam", folder_);
  ASSERT_EQ(drive.odometry.size(), 5U);  // 1.0, 1.1, 1.2, 1.25, 1.35
  EXPECT_EQ(drive.odometry[1].time, Time::seconds(1.1));
  EXPECT_EQ(drive.odometry[3].twist, (Twist2{0.4, 0.0}));
  EXPECT_NEAR(drive.odometry[3].X_OB.x, 0.1, 1e-12);
  EXPECT_NEAR(drive.odometry[4].X_OB.x, 0.1, 1e-12);
  EXPECT_NEAR(drive.odometry[4].X_OB.theta, 0.1570796, 1e-12);
  EXPECT_NEAR(*drive.truth.at(0).heading, 3.0, 1e-12);
}

TEST_F(ImportedLogs, MrclamFaultsAreRefused) {
  write("groundtruth_10hz.csv", "t_s,x_m,y_m,yaw_rad\n0,1,2,3\n0,1,2,3\n");
  write("odometry.csv", "t_s,v_mps,omega_radps\n1,200,0\n");
  EXPECT_THAT(complaint("mrclam"), HasSubstr("odometry.csv:2: column 2 (v_mps) = '200'"));
  write("odometry.csv", "t_s,v_mps,omega_radps\n1,0.4,0\n90,0,0\n");
  EXPECT_THAT(complaint("mrclam"),
              HasSubstr("groundtruth_10hz.csv:3: column 1 (t_s) = '0': is the stamp of the row before"));
  write("groundtruth_10hz.csv", "t_s,x_m,y_m,yaw_rad\n0,1,2,3\n");
  EXPECT_THAT(complaint("mrclam"),
              HasSubstr("/cmd_vel: a command cannot hold for more than 60 s, as that before 90.000 s does"));
}

// Both wheels 0.2 m/s for a second, then the left one alone 0.1 m/s: turn rate -0.1 / 0.157 rad/s.
TEST_F(ImportedLogs, LabyrinthIsReadAsWritten) {
  write(
      "Indoor_UWB_Input.txt",
      "range2 0 1.5 0.01 0 2 105 0 \nodom2diff 0 0 0 0 0.0785 0.0001 0.0001 0.0001\n"
      "odom2diff 1 0.2 0.2 0 0.0785 0.0001 0.0001 0.0001\nodom2diff 2 0.1 0 0 0.0785 0.0001 0.0001 0.0001\n");
  write("Indoor_UWB_GT.txt", "point2 0 1.5 2.5 0 0 0 0 \n");
  const RecordedDrive drive = read_log("labyrinth", folder_);
  ASSERT_EQ(drive.odometry.size(), 3U);
  EXPECT_NEAR(drive.odometry[1].X_OB.x, 0.2, 1e-12);
  EXPECT_NEAR(drive.odometry[2].twist.omega, -0.1 / 0.157, 1e-12);
  EXPECT_EQ(drive.wheel_separation, 0.157);
  EXPECT_EQ(drive.wheel_variance, 0.0001);
  ASSERT_EQ(drive.ranges.size(), 1U);
  EXPECT_EQ(drive.ranges[0].anchor, Vector2(0.0, 2.0));
  EXPECT_EQ(drive.ranges[0].range, 1.5);
  ASSERT_EQ(drive.truth.size(), 1U);
  EXPECT_FALSE(drive.truth[0].heading.has_value());
}

TEST_F(ImportedLogs, LabyrinthFaultsAreRefusedWithFileLineAndColumn) {
  write("Indoor_UWB_GT.txt", "point2 0 1.5 2.5 0 0 0 0\n");
  write("Indoor_UWB_Input.txt", "odom3 0 0 0\n");
  EXPECT_THAT(complaint("labyrinth"),
              HasSubstr("Input.txt:1: column 1 = 'odom3': no message is made of lines"));
  write("Indoor_UWB_Input.txt", "range2 0 1.5 0.01 0 2 105\n");
  EXPECT_THAT(complaint("labyrinth"), HasSubstr("Input.txt:1: 7 cells where 8 are expected"));
  write("Indoor_UWB_Input.txt", "\nrange2 0 nan 0.01 0 2 105 0\n");
  EXPECT_THAT(complaint("labyrinth"), HasSubstr("Input.txt:2: column 3 (range) = 'nan'"));
  write("Indoor_UWB_Input.txt", "range2 1 2 0.01 0 2 105 0\nrange2 0.5 2 0.01 0 2 105 0\n");
  EXPECT_THAT(complaint("labyrinth"), HasSubstr("Input.txt:2: column 2 (time) = '0.5': is before the stamp"));
  write("Indoor_UWB_Input.txt", "");
  write("Indoor_UWB_GT.txt", "point2 0 1.5 2.5 0 0 0\n");
  EXPECT_THAT(complaint("labyrinth"), HasSubstr("GT.txt:1: 7 cells where 8 are expected"));
}

// As many beams as the header has columns.
TEST_F(ImportedLogs, LaserKeepsBeamsWithoutReturnAndRefusesTheRest) {
  write("scans.csv", "t_s,r0,r1,r2\n0.5,1.25,inf,2.5\n");
  const RecordedDrive drive = read_log("laser", folder_);
  ASSERT_EQ(drive.scans.size(), 1U);
  EXPECT_THAT(drive.scans[0].ranges,
              testing::ElementsAre(1.25F, std::numeric_limits<float>::infinity(), 2.5F));
  EXPECT_EQ(drive.scans[0].frame, "laser");
  EXPECT_EQ(drive.scans[0].geometry.range_max, 5.6F);
  EXPECT_FLOAT_EQ(drive.scans[0].geometry.angle_max, -1.570796F + 2.0F * 0.006135923F);
  ASSERT_EQ(drive.odometry.size(), 1U);
  EXPECT_EQ(drive.odometry[0].time, Time::seconds(0.5));
  EXPECT_EQ(drive.odometry[0].twist, Twist2{});
  write("scans.csv", "t_s,r0,r1\n0.5,1.25,nan\n");
  EXPECT_THAT(complaint("laser"), HasSubstr("scans.csv:2: column 3 (r1) = 'nan'"));
  write("scans.csv", "t_s,r0,r1\n0.5,-1,2\n");
  EXPECT_THAT(complaint("laser"), HasSubstr("scans.csv:2: column 2 (r0) = '-1': must be between 0 and .inf"));
}

// Figures of the logs' own descriptions: counts, rates, and the distance that the vendor's odometry and the
// sum of its twists agree on.
TEST(RecordedLogs, AreReadWhole) {
  const char* shared = std::getenv("BANDWAGON_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "BANDWAGON_SHARED names no folder of recorded data";
  const auto data = std::filesystem::path(shared) / "data";
  const RecordedDrive husky = read_log("husky", data / "husky_odom_imu_gps");
  EXPECT_EQ(husky.odometry.size(), 3952U);
  EXPECT_EQ(husky.imu.size(), 11865U);
  EXPECT_EQ(husky.fixes.size(), 989U);
  OdometrySample summed = husky.odometry.front();
  for (std::size_t i = 1; i < husky.odometry.size(); ++i)
    summed = advance(summed, husky.odometry[i].twist, husky.odometry[i].time);
  EXPECT_LT((summed.X_OB.position() - husky.odometry.back().X_OB.position()).norm(), 0.5);

  const RecordedDrive mrclam = read_log("mrclam", data / "mrclam6_robot1");
  EXPECT_EQ(mrclam.truth.size(), 7076U);
  EXPECT_EQ(mrclam.odometry.front().time, Time::seconds(12.053));
  for (std::size_t i = 1; i < mrclam.odometry.size(); ++i)
    ASSERT_LE(mrclam.odometry[i].time - mrclam.odometry[i - 1].time, Duration::milliseconds(100));

  const RecordedDrive labyrinth = read_log("labyrinth", data / "tuc_labyrinth_uwb");
  EXPECT_EQ(labyrinth.odometry.size(), 233U);
  EXPECT_EQ(labyrinth.ranges.size(), 233U);
  EXPECT_EQ(labyrinth.truth.size(), 233U);
  // Its wheels alone keep to the reference, once rotated by the heading at the start (172 degrees).
  const Pose2 X_MO{labyrinth.truth.front().position.x(), labyrinth.truth.front().position.y(), 3.002};
  for (std::size_t i = 0; i < labyrinth.odometry.size(); ++i)
    ASSERT_LT((X_MO * labyrinth.odometry[i].X_OB.position() - labyrinth.truth[i].position).norm(), 0.2) << i;

  const RecordedDrive laser = read_log("laser", data / "people_laser_stationary");
  EXPECT_EQ(laser.scans.size(), 1265U);
  EXPECT_EQ(laser.scans.front().ranges.size(), 512U);
}

}  // namespace
}  // namespace bw
