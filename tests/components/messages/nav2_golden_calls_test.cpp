// To the last byte in hex, fields named: what every action shares, one action as the wire has it, and the
// services whose layouts differ. Hex as a check of the hand that writes the other tests' bytes.
#include <action_msgs/msg/goal_status_array.hpp>
#include <action_msgs/srv/cancel_goal.hpp>

#include "components/messages/nav2_layouts.hpp"
#include "tests/components/messages/nav2_golden.hpp"

namespace bw::test {
namespace {

const std::string kEncapsulation = "00010000 ";
const std::string kId = "20212223 24252627 28292a2b 2c2d2e2f ";

std::vector<std::uint8_t> hex(const std::string& digits) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    if (digits[i] == ' ') ++i;
    if (i < digits.size())
      bytes.push_back(static_cast<std::uint8_t>(std::stoi(digits.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

action_msgs::msg::GoalInfo goal_info() {
  action_msgs::msg::GoalInfo info;
  info.goal_id().uuid(id());
  info.stamp().sec(1);
  info.stamp().nanosec(2);
  return info;
}
const std::string kGoalInfo = kId + "01000000 02000000 ";  // goal_id, stamp

TEST(Nav2Golden, CancelGoal) {
  action_msgs::srv::CancelGoal::Request request;
  request.goal_info(goal_info());
  expect_wire(request, hex(kEncapsulation + kGoalInfo));
  action_msgs::srv::CancelGoal::Response response;
  response.return_code(3);
  expect_wire(response, hex(kEncapsulation + "03 000000 00000000"));  // return_code, padding, no goals
  response.return_code(0);
  response.goals_canceling({goal_info(), goal_info()});
  expect_wire(response, hex(kEncapsulation + "00 000000 02000000 " + kGoalInfo + kGoalInfo));
}

TEST(Nav2Golden, GoalStatusArray) {
  action_msgs::msg::GoalStatusArray array;
  expect_wire(array, hex(kEncapsulation + "00000000"));
  action_msgs::msg::GoalStatus status;
  status.goal_info(goal_info());
  status.status(2);
  array.status_list({status, status});
  // The second id follows the first status at once; its stamp is aligned.
  expect_wire(array,
              hex(kEncapsulation + "02000000 " + kGoalInfo + "02 " + kId + "000000 01000000 02000000 02"));
}

TEST(Nav2Golden, SpinInHex) {
  JazzyNav2::Spin::SendGoal::Request request;
  request.goal_id().uuid(id());
  request.goal().target_yaw(1.5F);
  request.goal().time_allowance(duration(10));
  expect_wire(request, hex(kEncapsulation + kId + "0000c03f 0a000000 0065cd1d"));
  HumbleNav2::Spin::GetResult::Response humble;
  humble.status(4);
  humble.result().total_elapsed_time(duration(4));
  expect_wire(humble, hex(kEncapsulation + "04 000000 04000000 0065cd1d"));
  JazzyNav2::Spin::GetResult::Response jazzy;
  jazzy.status(6);
  jazzy.result().total_elapsed_time(duration(4));
  jazzy.result().error_code(703);
  jazzy.result().error_msg("no");
  expect_wire(jazzy, hex(kEncapsulation + "06 000000 04000000 0065cd1d bf02 0000 03000000 6e6f00"));
}

// Jazzy's result of two bytes and an empty text where Humble's client expects one byte: such a client waits
// for ever.
TEST(Nav2Golden, NavigateToPosesResultInHex) {
  HumbleNav2::NavigateToPose::GetResult::Response humble;
  humble.status(4);
  expect_wire(humble, hex(kEncapsulation + "04 00"));
  JazzyNav2::NavigateToPose::GetResult::Response jazzy;
  jazzy.status(4);
  expect_wire(jazzy, hex(kEncapsulation + "04 00 0000 01000000 00"));
}

TEST(Nav2Golden, ClearCostmap) {
  expect_wire(JazzyNav2::ClearEntireCostmap::Request(), hex(kEncapsulation + "00"));
  expect_wire(JazzyNav2::ClearEntireCostmap::Response(), hex(kEncapsulation + "00"));
  JazzyNav2::ClearCostmapAroundRobot::Request around;
  around.reset_distance(1.5F);
  expect_wire(around, hex(kEncapsulation + "0000c03f"));
  EXPECT_TRUE((std::is_same_v<HumbleNav2::ClearEntireCostmap, KiltedNav2::ClearEntireCostmap>));
}

TEST(Nav2GoldenUnproved, ClearCostmapOfLyrical) {
  LyricalNav2::ClearEntireCostmap::Request entire;
  entire.plugins({"obstacles"});
  expect_wire(entire, hex(kEncapsulation + "01000000 0a000000 6f627374 61636c65 7300"));
  LyricalNav2::ClearEntireCostmap::Response cleared;
  cleared.success(true);
  expect_wire(cleared, hex(kEncapsulation + "01"));
  LyricalNav2::ClearCostmapAroundRobot::Request around;
  around.reset_distance(1.5F);
  expect_wire(around, hex(kEncapsulation + "0000c03f 00000000"));
  LyricalNav2::ClearCostmapExceptRegion::Request except;
  except.reset_distance(1.5F);
  except.plugins({"a"});
  expect_wire(except, hex(kEncapsulation + "0000c03f 01000000 02000000 6100"));
}

TEST(Nav2Golden, IsPathValid) {
  JazzyNav2::IsPathValid::Request request;
  request.path(path());
  CdrWriter requested;
  write_path(requested);
  expect_wire(request, requested.bytes());
  JazzyNav2::IsPathValid::Response response;
  response.is_valid(true);
  response.invalid_pose_indices({5});
  expect_wire(response, hex(kEncapsulation + "01 000000 01000000 05000000"));
}

TEST(Nav2GoldenUnproved, IsPathValidOfKiltedAndLyrical) {
  KiltedNav2::IsPathValid::Request kilted;
  kilted.path(path());
  kilted.max_cost(254);
  kilted.consider_unknown_as_obstacle(true);
  CdrWriter requested;
  write_path(requested);
  requested.put<std::uint8_t>(254).put<std::uint8_t>(1);
  expect_wire(kilted, requested.bytes());
  LyricalNav2::IsPathValid::Request lyrical;
  lyrical.path(path());
  lyrical.max_cost(254);
  lyrical.layer_name("static");
  lyrical.footprint("f");
  lyrical.stop_at_first_collision(true);
  lyrical.max_lookahead_distance(-1.0);
  CdrWriter asked;
  write_path(asked);
  asked.put<std::uint8_t>(254).put<std::uint8_t>(0).text("static").text("f").put<std::uint8_t>(1).doubles(
      -1.0);
  expect_wire(lyrical, asked.bytes());
  LyricalNav2::IsPathValid::Response response;
  response.success(true);
  response.invalid_pose_indices({5});
  expect_wire(response, hex(kEncapsulation + "01 00 0000 01000000 05000000"));  // success, is_valid
}

}  // namespace
}  // namespace bw::test
