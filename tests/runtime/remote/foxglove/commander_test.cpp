#include "runtime/remote/foxglove/commander.hpp"

#include <gtest/gtest.h>

namespace bw::foxglove {
namespace {

constexpr Duration kRelease = Duration::milliseconds(10'000);

TEST(Commander, OneAtATimeUntilItIsSilentOrGone) {
  Commander commander(true, kRelease);
  EXPECT_TRUE(commander.take(1, Time{0}));
  EXPECT_FALSE(commander.take(2, Time::seconds(5)));
  EXPECT_TRUE(commander.take(1, Time::seconds(6)));
  EXPECT_FALSE(commander.take(2, Time::seconds(15.9)));  // 9.9 s after the last command
  EXPECT_TRUE(commander.take(2, Time::seconds(16)));
  EXPECT_EQ(commander.holder(), 2U);
  commander.leave(1);
  EXPECT_EQ(commander.holder(), 2U);
  commander.leave(2);
  EXPECT_EQ(commander.holder(), std::nullopt);
  EXPECT_TRUE(commander.take(1, Time::seconds(16)));
}

TEST(Commander, AmongAllTheLastOneIsKnown) {
  Commander commander(false, kRelease);
  EXPECT_TRUE(commander.take(1, Time{0}));
  EXPECT_TRUE(commander.take(2, Time{0}));
  EXPECT_EQ(commander.holder(), 2U);
  commander.tick(Time::seconds(9.9));
  EXPECT_EQ(commander.holder(), 2U);
  commander.tick(Time::seconds(10));
  EXPECT_EQ(commander.holder(), std::nullopt);
}

TEST(Commander, ServicesThatOnlyAsk) {
  EXPECT_TRUE(only_asks("rcl_interfaces/srv/DescribeParameters"));
  EXPECT_TRUE(only_asks("lifecycle_msgs/srv/GetState"));
  EXPECT_TRUE(only_asks("nav2_msgs/action/NavigateToPose_GetResult"));
  EXPECT_FALSE(only_asks("nav2_msgs/action/NavigateToPose_SendGoal"));
  EXPECT_FALSE(only_asks("action_msgs/srv/CancelGoal"));
  EXPECT_FALSE(only_asks("rcl_interfaces/srv/SetParameters"));
  EXPECT_FALSE(only_asks("lifecycle_msgs/srv/ChangeState"));
  EXPECT_FALSE(only_asks("some_msgs/srv/Fire_GetResult"));
  EXPECT_FALSE(only_asks(""));
}

}  // namespace
}  // namespace bw::foxglove
