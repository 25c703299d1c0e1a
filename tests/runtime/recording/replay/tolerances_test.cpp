#include "runtime/recording/replay/tolerances.hpp"

#include <gmock/gmock.h>

#include "runtime/parameters/yaml_file.hpp"

namespace bw::replay {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<bag::BagTopic> topics() {
  return {{.name = "/odom", .type = "nav_msgs/msg/Odometry"},
          {.name = "/tracks", .type = "bandwagon_msgs/msg/Tracks"}};
}

Tolerances read(const std::string& yaml) { return read_tolerances(parse_yaml(yaml, "graph.yaml"), topics()); }

std::string refusal(const std::string& yaml) {
  try {
    static_cast<void>(read(yaml));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(Tolerances, TheLongestNameThatHoldsCounts) {
  const Tolerances t = read("/odom: {pose: 0.1, pose.pose.position: 0.02, twist.covariance: left_out}");
  const TopicTolerances& odom = t.at("/odom");
  EXPECT_EQ(odom.allowed("pose.pose.position.x"), 0.02);
  EXPECT_EQ(odom.allowed("pose.pose.orientation.w"), 0.1);
  EXPECT_EQ(odom.allowed("twist.twist.linear.x"), 0.0);
  EXPECT_EQ(odom.allowed("pose_other"), 0.0) << "a name is not a beginning of letters";
  EXPECT_TRUE(odom.leaves_out("twist.covariance"));
  EXPECT_FALSE(odom.leaves_out("twist.twist.linear.x"));
}

TEST(Tolerances, AWrongOneNamesFileLineKeyAndRule) {
  EXPECT_THAT(
      refusal("/odom: {pose.pose.positoin: 1}"),
      HasSubstr("graph.yaml:1: tolerances./odom.pose.pose.positoin: unknown field of geometry_msgs/msg/Pose; "
                "did you mean 'position'?"));
  EXPECT_THAT(refusal("/odom:\n  pose: -1"),
              HasSubstr("graph.yaml:2: tolerances./odom.pose = -1: must be a number of at "
                        "least 0, or left_out"));
  EXPECT_THAT(refusal("/odom: {pose: much}"), HasSubstr("= much: must be a number"));
  EXPECT_THAT(refusal("/odom: 1"), HasSubstr("must be a map of fields"));
  EXPECT_THAT(refusal("/odom: {child_frame_id.x: 1}"),
              HasSubstr("'x' stands below a field that has no parts"));
}

TEST(Tolerances, ATopicThatTheBagDoesNotHaveIsNotLookedAt) {
  EXPECT_EQ(read("/other: {anything: 1}").at("/other").allowed("anything"), 1.0);
}

}  // namespace
}  // namespace bw::replay
