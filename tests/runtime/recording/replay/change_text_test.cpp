#include "runtime/recording/replay/change_text.hpp"

#include <gmock/gmock.h>
#include <sensor_msgs/msg/laser_scan.hpp>

#include "tests/runtime/recording/replay/messages.hpp"

namespace bw::replay {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kTwist = "geometry_msgs/msg/TwistStamped";

TEST(ChangeText, RoundsAndLeavesOutZerosAndStamps) {
  ChangeText text(Time::seconds(100.0));
  text.add("/cmd_vel", kTwist, Time::seconds(100.25), twist(100.2, 0.12349, -0.0004));
  EXPECT_EQ(text.text(), "/cmd_vel geometry_msgs/msg/TwistStamped\n  0.250 twist.linear.x=0.123\n");
}

// Periods of 0.2 s: of 0.00, 0.05, 0.19, 0.20 and 0.45 s stand 0.00, 0.20 and 0.45.
TEST(ChangeText, OneMessageInAPeriod) {
  ChangeText text(Time{});
  for (const double t : {0.0, 0.05, 0.19, 0.2, 0.45})
    text.add("/cmd_vel", kTwist, Time::seconds(t), twist(t, 1.0 + t));
  EXPECT_EQ(
      text.text(),
      "/cmd_vel geometry_msgs/msg/TwistStamped\n  0.000 twist.linear.x=1\n  0.200 twist.linear.x=1.2\n  0.450 "
      "twist.linear.x=1.45\n");
}

// 20 ranges 1, 2, ..., 20: mean 10.5; 12 stand one by one.
TEST(ChangeText, LongListsStandByTheirRange) {
  for (const int count : {20, 12}) {
    sensor_msgs::msg::LaserScan scan;
    for (int i = 1; i <= count; ++i) scan.ranges().push_back(static_cast<float>(i));
    ChangeText text(Time{});
    text.add("/scan", "sensor_msgs/msg/LaserScan", Time{}, bytes_of(scan));
    if (count == 20) {
      EXPECT_THAT(text.text(), HasSubstr("ranges[]={20 from 1 to 20, mean 10.5}"));
      EXPECT_THAT(text.text(), Not(HasSubstr("ranges[3]")));
    } else {
      EXPECT_THAT(text.text(), HasSubstr("ranges[11]=12"));
    }
  }
}

TEST(ChangeText, PicturesAreLeftOut) {
  ChangeText text(Time{});
  text.add("/m", "visualization_msgs/msg/MarkerArray", Time{}, {});
  EXPECT_EQ(text.text(), "");
}

}  // namespace
}  // namespace bw::replay
