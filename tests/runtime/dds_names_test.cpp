// ROS 2's names on DDS, by its own rules (rmw_fastrtps).
#include "runtime/ros/dds_names.hpp"

#include <gtest/gtest.h>

namespace bw {
namespace {

TEST(DdsNames, GoThereAndBack) {
  EXPECT_EQ(dds_topic("/robot1/odom"), "rt/robot1/odom");
  EXPECT_EQ(ros_topic("rt/robot1/odom"), "/robot1/odom");
  EXPECT_EQ(dds_type("nav_msgs/msg/Odometry"), "nav_msgs::msg::dds_::Odometry_");
  EXPECT_EQ(ros_type("nav_msgs::msg::dds_::Odometry_"), "nav_msgs/msg/Odometry");
}

TEST(DdsNames, WhatIsNotRos2sStaysAsItIs) {
  EXPECT_EQ(ros_topic("ros_discovery_info"), "ros_discovery_info");
  EXPECT_EQ(ros_type("HelloWorld"), "HelloWorld");
  EXPECT_EQ(dds_type("HelloWorld"), "HelloWorld");
}

TEST(DdsNames, TheHashStandsInTheUserData) {
  EXPECT_EQ(type_hash_in("typehash=RIHS01_ab;"), "RIHS01_ab");
  EXPECT_EQ(type_hash_in("a=b;typehash=RIHS01_ab"), "RIHS01_ab");
  EXPECT_EQ(type_hash_in(""), "");
  EXPECT_EQ(user_data_of("RIHS01_ab"), "typehash=RIHS01_ab;");
  EXPECT_EQ(user_data_of(""), "");
}

}  // namespace
}  // namespace bw
