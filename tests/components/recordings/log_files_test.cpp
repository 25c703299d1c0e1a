#include "components/recordings/files/log_files.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bw {
namespace {

using ::testing::HasSubstr;

class LogFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) /
              ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }

  /// What the reader says of the folder; empty when it reads it.
  template <class Reader>
  std::string complaint(Reader read) {
    try {
      read(folder_);
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

TEST_F(LogFiles, HuskyIsReadAsWritten) {
  write("wheel_odom.csv", std::string(kHuskyWheels) + "0.5,1,2,7,0.25,-0.5\n0.6,1,2,0.1,0.25,-0.5\n");
  write("imu.csv", std::string(kHuskyImu) + "0.25,0,0,0,1,9,9,9,9,9,9,9,-0.2,0.03\n");
  write("gps.csv", std::string(kHuskyFixes) + "1,-1,0,0,0,1,1,1\n2,1,42.5,-71.25,7,0.81,0.64,3\n");
  const RecordedDrive drive = read_husky_log(folder_);
  ASSERT_EQ(drive.odometry.size(), 2U);
  EXPECT_EQ(drive.odometry[0].time, Time::seconds(0.5));
  EXPECT_EQ(drive.odometry[0].X_OB, (Pose2{1.0, 2.0, wrap_angle(7.0)}));
  EXPECT_EQ(drive.odometry[0].twist, (Twist2{0.25, -0.5}));
  ASSERT_EQ(drive.imu.size(), 1U);
  EXPECT_EQ(*drive.imu[0].heading, -0.2);
  EXPECT_EQ(*drive.imu[0].turn_rate, 0.03);
  ASSERT_EQ(drive.fixes.size(), 1U);  // status -1 is no fix
  EXPECT_EQ(drive.fixes[0].place.longitude, -71.25);
  EXPECT_EQ(drive.fixes[0].variance, Eigen::Vector3d(0.81, 0.64, 3.0));
  EXPECT_EQ(drive.datum.latitude, 42.5);
}

TEST_F(LogFiles, HuskyFaultsAreRefusedWithFileAndLine) {
  write("wheel_odom.csv", kHuskyWheels);
  write("imu.csv", kHuskyImu);
  EXPECT_THAT(complaint(read_husky_log), HasSubstr("gps.csv: cannot be opened"));
  write("gps.csv", "t_s,lat_deg,lon_deg,alt_m,var_e_m2,var_n_m2,var_u_m2\n");
  EXPECT_THAT(complaint(read_husky_log), HasSubstr("gps.csv:1: column 2 of the header must be 'status'"));
  write("gps.csv", std::string(kHuskyFixes) + "1,1,42,-71,0,1,1,1\n2,1,92,-71,0,1,1,1\n");
  EXPECT_THAT(complaint(read_husky_log), HasSubstr("gps.csv:3: this is no place on earth"));
  write("gps.csv", std::string(kHuskyFixes) + "1,1,42,-71,0,0,1,1\n");
  EXPECT_THAT(complaint(read_husky_log), HasSubstr("gps.csv:2: variances"));
  write("gps.csv", std::string(kHuskyFixes) + "1,1,42,-71,0,1,1\n");
  EXPECT_THAT(complaint(read_husky_log), HasSubstr("gps.csv:2: 7 values where the header names 8"));
  write("gps.csv", kHuskyFixes);
  write("wheel_odom.csv", std::string(kHuskyWheels) + "1,0,0,0,0,0\n2,0,0,nan,0,0\n");
  EXPECT_THAT(complaint(read_husky_log), HasSubstr("wheel_odom.csv:3: 'nan' is not a finite number"));
  write("wheel_odom.csv", std::string(kHuskyWheels) + "1,0,0,0,0,0\n0.9,0,0,0,0,0\n");
  EXPECT_THAT(complaint(read_husky_log), HasSubstr("wheel_odom.csv:3: stamps must rise"));
  write("wheel_odom.csv", std::string(kHuskyWheels) + "1e300,0,0,0,0,0\n");
  EXPECT_THAT(complaint(read_husky_log), HasSubstr("wheel_odom.csv:2: the stamp must lie within"));
}

// Commands held: 0.4 m/s for 0.25 s (0.1 m), then pi/2 rad/s for 0.1 s.
TEST_F(LogFiles, MrclamHoldsEachCommandUntilTheNext) {
  write("odometry.csv", "t_s,v_mps,omega_radps\n1,0.4,0\n1.25,0,1.570796\n1.35,0,0\n");
  write("groundtruth_10hz.csv", "t_s,x_m,y_m,yaw_rad\n0,1,2,3\n");
  const RecordedDrive drive = read_mrclam_log(folder_);
  ASSERT_EQ(drive.odometry.size(), 5U);  // 1.0, 1.1, 1.2, 1.25, 1.35
  EXPECT_EQ(drive.odometry[1].time, Time::seconds(1.1));
  EXPECT_EQ(drive.odometry[3].twist, (Twist2{0.4, 0.0}));
  EXPECT_NEAR(drive.odometry[3].X_OB.x, 0.1, 1e-12);
  EXPECT_NEAR(drive.odometry[4].X_OB.x, 0.1, 1e-12);
  EXPECT_NEAR(drive.odometry[4].X_OB.theta, 0.1570796, 1e-12);
  EXPECT_EQ(*drive.truth.at(0).heading, 3.0);
}

TEST_F(LogFiles, MrclamFaultsAreRefusedWithFileAndLine) {
  write("groundtruth_10hz.csv", "t_s,x_m,y_m,yaw_rad\n0,1,2,3\n0,1,2,3\n");
  write("odometry.csv", "t_s,v_mps,omega_radps\n1,0.4,0\n90,0,0\n");
  EXPECT_THAT(complaint(read_mrclam_log), HasSubstr("odometry.csv:3: a command cannot hold"));
  write("odometry.csv", "t_s,v_mps,omega_radps\n1,200,0\n");
  EXPECT_THAT(complaint(read_mrclam_log), HasSubstr("odometry.csv:2: v_mps"));
  write("odometry.csv", "t_s,v_mps,omega_radps\n1,0.4,0\n");
  EXPECT_THAT(complaint(read_mrclam_log), HasSubstr("groundtruth_10hz.csv:3: stamps must rise"));
}

// Both wheels 0.2 m/s for a second, then the left one alone 0.1 m/s: turn rate -0.1 / (2 * 0.05) rad/s.
TEST_F(LogFiles, LabyrinthIsReadAsWritten) {
  write("Indoor_UWB_Input.txt",
        "range2 0 1.5 0.01 0 2 105 0 \nodom2diff 0 0 0 0 0.05 0.0001 0.0001 0.0001\n"
        "odom2diff 1 0.2 0.2 0 0.05 0.0001 0.0001 0.0001\nodom2diff 2 0.1 0 0 0.05 0.0001 0.0001 0.0001\n");
  write("Indoor_UWB_GT.txt", "point2 0 1.5 2.5 0 0 0 0 \n");
  const RecordedDrive drive = read_labyrinth_log(folder_);
  ASSERT_EQ(drive.odometry.size(), 3U);
  EXPECT_NEAR(drive.odometry[1].X_OB.x, 0.2, 1e-12);
  EXPECT_NEAR(drive.odometry[2].twist.omega, -1.0, 1e-12);
  EXPECT_EQ(drive.wheel_separation, 0.1);
  ASSERT_EQ(drive.ranges.size(), 1U);
  EXPECT_EQ(drive.ranges[0].anchor, Vector2(0.0, 2.0));
  EXPECT_EQ(drive.ranges[0].range, 1.5);
  ASSERT_EQ(drive.truth.size(), 1U);
  EXPECT_FALSE(drive.truth[0].heading.has_value());
}

TEST_F(LogFiles, LabyrinthFaultsAreRefusedWithFileAndLine) {
  write("Indoor_UWB_GT.txt", "point2 0 1.5 2.5 0 0 0 0\n");
  write("Indoor_UWB_Input.txt", "odom3 0 0 0\n");
  EXPECT_THAT(complaint(read_labyrinth_log), HasSubstr("Input.txt:1: a line must be odom2diff or range2"));
  write("Indoor_UWB_Input.txt", "range2 0 1.5 0.01 0 2 105\n");
  EXPECT_THAT(complaint(read_labyrinth_log), HasSubstr("Input.txt:1: range2 must have 7 values, found 6"));
  write("Indoor_UWB_Input.txt", "\nrange2 0 nan 0.01 0 2 105 0\n");
  EXPECT_THAT(complaint(read_labyrinth_log), HasSubstr("Input.txt:2: 'nan' is not a finite number"));
  write("Indoor_UWB_Input.txt", "range2 1 2 0.01 0 2 105 0\nrange2 0.5 2 0.01 0 2 105 0\n");
  EXPECT_THAT(complaint(read_labyrinth_log), HasSubstr("Input.txt:2: stamps must rise"));
  write("Indoor_UWB_Input.txt", "");
  write("Indoor_UWB_GT.txt", "point2 0 1.5 2.5 0 0 0\n");
  EXPECT_THAT(complaint(read_labyrinth_log), HasSubstr("GT.txt:1: point2 must have 7 values"));
}

std::string scan_lines(const std::string& range) {
  std::string header = "t_s";
  std::string row = "0.5";
  for (int beam = 0; beam < 512; ++beam) {
    header += ",r" + std::to_string(beam);
    row += beam == 3 ? "," + range : ",1.25";
  }
  return header + "\n" + row + "\n";
}

TEST_F(LogFiles, LaserKeepsBeamsWithoutReturnAndRefusesTheRest) {
  write("scans.csv", scan_lines("inf"));
  const RecordedDrive drive = read_laser_log(folder_);
  ASSERT_EQ(drive.scans.size(), 1U);
  ASSERT_EQ(drive.scans[0].ranges.size(), 512U);
  EXPECT_EQ(drive.scans[0].ranges[3], std::numeric_limits<float>::infinity());
  EXPECT_EQ(drive.scans[0].ranges[4], 1.25F);
  ASSERT_EQ(drive.odometry.size(), 1U);
  EXPECT_EQ(drive.odometry[0].time, Time::seconds(0.5));
  write("scans.csv", scan_lines("nan"));
  EXPECT_THAT(complaint(read_laser_log), HasSubstr("scans.csv:2: 'nan' is not a number"));
  write("scans.csv", scan_lines("-inf"));
  EXPECT_THAT(complaint(read_laser_log), HasSubstr("scans.csv:2: a range cannot be negative"));
}

// Figures of the logs' own descriptions: counts, rates, and the way that the vendor's odometry and the sum of
// its twists agree on.
TEST(RecordedLogs, AreReadWhole) {
  const char* shared = std::getenv("BANDWAGON_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "BANDWAGON_SHARED names no folder of recorded data";
  const auto data = std::filesystem::path(shared) / "data";
  const RecordedDrive husky = read_husky_log(data / "husky_odom_imu_gps");
  EXPECT_EQ(husky.odometry.size(), 3952U);
  EXPECT_EQ(husky.imu.size(), 11865U);
  EXPECT_EQ(husky.fixes.size(), 989U);
  OdometrySample summed = husky.odometry.front();
  for (std::size_t i = 1; i < husky.odometry.size(); ++i)
    summed = advance(summed, husky.odometry[i].twist, husky.odometry[i].time);
  EXPECT_LT((summed.X_OB.position() - husky.odometry.back().X_OB.position()).norm(), 0.5);

  const RecordedDrive mrclam = read_mrclam_log(data / "mrclam6_robot1");
  EXPECT_EQ(mrclam.truth.size(), 7076U);
  EXPECT_EQ(mrclam.odometry.front().time, Time::seconds(12.053));
  for (std::size_t i = 1; i < mrclam.odometry.size(); ++i)
    ASSERT_LE(mrclam.odometry[i].time - mrclam.odometry[i - 1].time, Duration::milliseconds(100));

  const RecordedDrive labyrinth = read_labyrinth_log(data / "tuc_labyrinth_uwb");
  EXPECT_EQ(labyrinth.odometry.size(), 233U);
  EXPECT_EQ(labyrinth.ranges.size(), 233U);
  EXPECT_EQ(labyrinth.truth.size(), 233U);
  // Its wheels alone keep to the reference, once turned by the heading at the start (172 degrees).
  const Pose2 X_MO{labyrinth.truth.front().position.x(), labyrinth.truth.front().position.y(), 3.002};
  for (std::size_t i = 0; i < labyrinth.odometry.size(); ++i)
    ASSERT_LT((X_MO * labyrinth.odometry[i].X_OB.position() - labyrinth.truth[i].position).norm(), 0.2) << i;

  const RecordedDrive laser = read_laser_log(data / "people_laser_stationary");
  EXPECT_EQ(laser.scans.size(), 1265U);
}

}  // namespace
}  // namespace bw
