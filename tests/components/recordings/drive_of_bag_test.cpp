// Bags of any robot as drives: by the stamps of their messages, with what their headers say; what does not
// fit is told.
#include "components/recordings/files/drive_of_bag.hpp"

#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <geometry_msgs/msg/twist_stamped.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/imu.hpp>
#include <sensor_msgs/msg/joint_state.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <sensor_msgs/msg/nav_sat_fix.hpp>
#include <tf2_msgs/msg/tf_message.hpp>
#include <unistd.h>

#include "components/messages/geometry.hpp"
#include "tests/components/recordings/bags.hpp"

namespace bw {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kStart = 1'700'000'000.0;  // of a bag of today [s]
Time today(double seconds) { return Time::seconds(kStart) + Duration::seconds(seconds); }
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

nav_msgs::msg::Odometry odometry(Time time, const Pose2& X_OB, const Twist2& twist = {}) {
  nav_msgs::msg::Odometry message;
  message.header(make_header("odom", time));
  message.pose().pose(to_pose(X_OB));
  message.twist().twist(to_twist_message(twist));
  return message;
}

class DriveOfBag : public ::testing::Test {
 protected:
  BagDrive read(const DriveTopics& topics = {}, const WheelSizes& wheels = {}) {
    bag_.close();
    return drive_of_bag(*bag::open_bag(file_), topics, file_.string(), wheels);
  }
  std::string refusal(const DriveTopics& topics = {}) {
    try {
      read(topics);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }
  void TearDown() override { std::filesystem::remove(file_); }

  std::filesystem::path file_ = std::filesystem::path(::testing::TempDir()) /
                                ("drive_" + std::to_string(getpid()) +
                                 ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".mcap");
  TestBag bag_{file_};
};

TEST_F(DriveOfBag, CountsTimeFromTheFirstStampAndNotFromTheRecordersClock) {
  bag_.add("/odom", kStart + 5.5, odometry(today(1.0), {1, 2, 0.5}, {0.25, 0.125}));
  bag_.add("/odom", kStart + 5.75, odometry(today(1.25), {1.5, 2, 0.5}));
  sensor_msgs::msg::LaserScan scan;
  scan.header(make_header("front", today(0.5)));
  scan.angle_min(-2.0F);
  scan.angle_max(2.0F);
  scan.angle_increment(0.5F);
  scan.time_increment(0.001F);
  scan.scan_time(0.25F);
  scan.range_min(0.125F);
  scan.range_max(40.0F);
  scan.ranges(std::vector<float>(9, 3.0F));
  scan.intensities(std::vector<float>(9, 7.0F));
  bag_.add("/scan", kStart + 6.0, scan);
  const BagDrive read = this->read();
  ASSERT_EQ(read.drive.odometry.size(), 2U);
  EXPECT_EQ(read.drive.odometry[0].time, Time::seconds(0.5));
  EXPECT_EQ(read.drive.odometry[1].time, Time::seconds(0.75));
  EXPECT_EQ(read.drive.odometry[0].twist, (Twist2{0.25, 0.125}));
  ASSERT_EQ(read.drive.scans.size(), 1U);
  const ScanSample& sample = read.drive.scans[0];
  EXPECT_EQ(sample.time, Time{});
  EXPECT_EQ(sample.frame, "front");
  EXPECT_EQ(sample.geometry.angle_min, -2.0F);
  EXPECT_EQ(sample.geometry.time_increment, 0.001F);
  EXPECT_EQ(sample.geometry.range_max, 40.0F);
  EXPECT_EQ(sample.ranges.size(), 9U);
  EXPECT_EQ(sample.intensities, std::vector<float>(9, 7.0F));
  EXPECT_TRUE(read.left_out.empty());
  EXPECT_EQ(read.log.name, file_.stem().string());
}

TEST_F(DriveOfBag, ReadsSeveralScannersUnderTheirOwnNames) {
  sensor_msgs::msg::LaserScan scan;
  scan.header(make_header("rear", Time::seconds(2)));
  bag_.add("/rear/scan", 2, scan);
  scan.header(make_header("front", Time::seconds(2)));
  bag_.add("/front/scan", 2, scan);
  const BagDrive read = this->read({.scans = {"/front/scan", "/rear/scan"}});
  ASSERT_EQ(read.drive.scans.size(), 2U);  // of one stamp
  EXPECT_EQ(read.drive.scans[0].frame, "rear");
  EXPECT_EQ(read.drive.scans[1].frame, "front");
}

// An inertial unit without orientation, another without turn rate; a fix without covariance, and none.
TEST_F(DriveOfBag, WhatIsNotMeasuredIsNotThere) {
  sensor_msgs::msg::Imu imu;
  imu.header(make_header("imu_link", Time::seconds(1)));
  imu.orientation_covariance()[0] = -1.0;
  imu.angular_velocity().z(0.5);
  bag_.add("/imu", 1, imu);
  imu.header(make_header("imu_link", Time::seconds(2)));
  imu.orientation_covariance()[0] = 0.0;
  imu.orientation_covariance()[8] = 0.25;
  imu.orientation(to_quaternion(1.5));
  imu.angular_velocity_covariance()[0] = -1.0;
  bag_.add("/imu", 2, imu);
  sensor_msgs::msg::NavSatFix fix;
  fix.header(make_header("antenna", Time::seconds(1)));
  fix.latitude(50.0);
  fix.altitude(kNan);
  bag_.add("/gps/fix", 1, fix);
  fix.status().status(-1);
  bag_.add("/gps/fix", 2, fix);
  const BagDrive read = this->read();
  ASSERT_EQ(read.drive.imu.size(), 2U);
  EXPECT_FALSE(read.drive.imu[0].heading);
  EXPECT_EQ(read.drive.imu[0].turn_rate, 0.5);
  EXPECT_NEAR(*read.drive.imu[1].heading, 1.5, 1e-12);
  EXPECT_EQ(read.drive.imu[1].heading_variance, 0.25);
  EXPECT_FALSE(read.drive.imu[1].turn_rate);
  EXPECT_EQ(read.drive.imu_frame, "imu_link");
  ASSERT_EQ(read.drive.fixes.size(), 1U);
  EXPECT_TRUE(read.drive.fixes[0].variance.isZero());
  EXPECT_EQ(read.drive.gps_frame, "antenna");
  EXPECT_THAT(read.left_out, ElementsAre(HasSubstr("/gps/fix: 1 messages hold nothing of use")));
}

TEST_F(DriveOfBag, SumsCommandsAndWheelsWhereThereIsNoOdometry) {
  sensor_msgs::msg::JointState joints;
  joints.name({"right_wheel_joint", "left_wheel_joint"});
  joints.velocity({4.0, 2.0});
  bag_.add("/joint_states", 1, joints);
  bag_.add("/joint_states", 2, joints);
  // 0.1 m wheels 0.4 m apart: (0.4 + 0.2) / 2 m/s, (0.4 - 0.2) / 0.4 rad/s.
  const BagDrive read = this->read({}, {.separation = 0.4, .radius = 0.1});
  ASSERT_EQ(read.drive.odometry.size(), 2U);
  EXPECT_NEAR(read.drive.odometry[1].twist.v, 0.3, 1e-12);
  EXPECT_NEAR(read.drive.odometry[1].X_OB.theta, 0.5, 1e-12);
  EXPECT_EQ(read.drive.wheel_separation, 0.4);
}

TEST_F(DriveOfBag, WheelsOfUnknownSizeAreRefused) {
  sensor_msgs::msg::JointState joints;
  joints.name({"left_wheel_joint", "right_wheel_joint"});
  joints.velocity({1.0, 1.0});
  bag_.add("/joint_states", 1, joints);
  EXPECT_THAT(refusal(), HasSubstr("/joint_states: nobody declares the wheels' radius"));
}

TEST_F(DriveOfBag, TheRecordOfTheLogHolds) {
  bag_.add("/odom", 7, odometry(Time::seconds(7), {}));
  bag_.add_metadata(
      "log", {{"name", "n"}, {"source", "s"}, {"licence", "l"}, {"start", "2"}, {"wheel_separation", "0.5"}});
  const BagDrive read = this->read({}, {.separation = 9.0});
  EXPECT_EQ(read.log.name, "n");
  EXPECT_EQ(read.log.source, "s");
  EXPECT_EQ(read.log.licence, "l");
  EXPECT_EQ(read.drive.odometry.at(0).time, Time::seconds(5));
  EXPECT_EQ(read.drive.wheel_separation, 0.5);
}

TEST_F(DriveOfBag, AReferenceMayBeAnyOfThreeTypes) {
  geometry_msgs::msg::PoseStamped pose;
  pose.header(make_header("map", Time::seconds(1)));
  pose.pose().orientation().w(0.0);
  bag_.add("/pose", 1, pose);
  bag_.add("/odometry", 1, odometry(Time::seconds(1), {3, 4, 0.5}));
  bandwagon_msgs::msg::GroundTruth truth;
  truth.pose(to_pose({5, 6, 0.75}));
  bag_.add("/sim/ground_truth", 2, truth);  // without a stamp: the recorder's
  bag_.close();
  const auto bag = bag::open_bag(file_);
  const auto truth_of = [&](const char* topic) {
    return drive_of_bag(*bag, {.truth = topic}, "bag").drive.truth.at(0);
  };
  EXPECT_FALSE(truth_of("/pose").heading);
  EXPECT_NEAR(*truth_of("/odometry").heading, 0.5, 1e-12);
  EXPECT_EQ(truth_of("/sim/ground_truth").position, Vector2(5, 6));
}

TEST_F(DriveOfBag, MessagesThatAreNoneAndStampsThatFallAreCountedNotTaken) {
  bag_.add("/odom", 1, odometry(Time::seconds(1), {1, 0, 0}));
  bag_.add("/odom", 2, odometry(Time::seconds(3), {3, 0, 0}));
  bag_.add("/odom", 3, odometry(Time::seconds(2), {2, 0, 0}));  // met late
  bag_.add("/odom", 4, odometry(Time::seconds(2), {9, 0, 0}));  // said twice
  bag_.add("/odom", 5, odometry(Time::seconds(5), {kNan, 0, 0}));
  bag_.add_bytes("/odom", "nav_msgs/msg/Odometry", 6, {0, 1, 0, 0, 7});
  const BagDrive read = this->read();
  std::vector<double> x;
  for (const OdometrySample& sample : read.drive.odometry) x.push_back(sample.X_OB.x);
  EXPECT_THAT(x, ElementsAre(1, 2, 3));
  EXPECT_THAT(read.left_out, ElementsAre(HasSubstr("/odom: 1 messages are no messages of its type"),
                                         HasSubstr("/odom: 1 messages hold nothing of use"),
                                         HasSubstr("/odom: 1 messages have the stamp of another")));
}

TEST_F(DriveOfBag, ATopicOfAnotherTypeIsRefused) {
  bag_.add("/odom", 1, geometry_msgs::msg::TwistStamped());
  EXPECT_THAT(
      refusal(),
      HasSubstr(".mcap: /odom is geometry_msgs/msg/TwistStamped, and nav_msgs/msg/Odometry is needed"));
}

TEST_F(DriveOfBag, ATopicThatWasNamedMustBeThere) {
  bag_.add("/odom", 1, odometry(Time::seconds(1), {}));
  EXPECT_THAT(refusal({.imu = "/imu/data"}), HasSubstr("there is no topic /imu/data; there are: /odom"));
}

TEST_F(DriveOfBag, ABagWithoutADriveIsRefused) {
  bag_.add("/chatter", 1, odometry(Time::seconds(1), {}));
  EXPECT_THAT(refusal(), HasSubstr("nothing of a drive in it"));
  EXPECT_THAT(refusal(), HasSubstr("its topics: /chatter"));
}

TEST_F(DriveOfBag, MountsOfTheBagAreKept) {
  bag_.add("/odom", 1, odometry(Time::seconds(1), {}));
  tf2_msgs::msg::TFMessage tf;
  tf.transforms().push_back(to_transform("base_link", "front", Time{}, {0.5, -0.25, 1.0}));
  bag_.add("/tf_static", 1, tf);
  const BagDrive read = this->read();
  ASSERT_EQ(read.drive.mounts.size(), 1U);
  EXPECT_EQ(read.drive.mounts[0].child, "front");
  EXPECT_EQ(read.drive.mounts[0].translation.y(), -0.25);
  EXPECT_EQ(read.drive.mounts[0].rotation(3), std::cos(0.5));
}

}  // namespace
}  // namespace bw
