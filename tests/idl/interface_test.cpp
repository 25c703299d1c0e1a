// What users of services and actions write down: the struct that names the parts, constants, the empty
// request.
#include <type_traits>

#include <gtest/gtest.h>

#include "lifecycle_msgs/msg/state.hpp"
#include "nav2_msgs/action/navigate_to_pose.hpp"
#include "nav2_msgs/srv/manage_lifecycle_nodes.hpp"
#include "nav_msgs/srv/load_map.hpp"
#include "slam_toolbox/srv/save_map.hpp"
#include "slam_toolbox/srv/serialize_pose_graph.hpp"
#include "std_srvs/srv/trigger.hpp"

namespace bw::test {
namespace {

TEST(Interface, AServiceNamesItsParts) {
  using std_srvs::srv::Trigger;
  EXPECT_EQ(Trigger::ros_name, "std_srvs/srv/Trigger");
  EXPECT_TRUE((std::is_same_v<Trigger::Request, std_srvs::srv::Trigger_Request>));
  EXPECT_TRUE((std::is_same_v<Trigger::Response, std_srvs::srv::Trigger_Response>));
  EXPECT_TRUE((std::is_same_v<Trigger::Event, std_srvs::srv::Trigger_Event>));
  EXPECT_EQ(MessageTraits<Trigger::Request>::dds_name, "std_srvs::srv::dds_::Trigger_Request_");
}

TEST(Interface, AnActionNamesItsParts) {
  using nav2_msgs::action::NavigateToPose;
  EXPECT_EQ(NavigateToPose::ros_name, "nav2_msgs/action/NavigateToPose");
  EXPECT_EQ(NavigateToPose::SendGoal::ros_name, "nav2_msgs/action/NavigateToPose_SendGoal");
  EXPECT_EQ(MessageTraits<NavigateToPose::GetResult::Response>::dds_name,
            "nav2_msgs::action::dds_::NavigateToPose_GetResult_Response_");
  EXPECT_EQ(MessageTraits<NavigateToPose::FeedbackMessage>::ros_name,
            "nav2_msgs/action/NavigateToPose_FeedbackMessage");
  NavigateToPose::SendGoal::Request request;
  NavigateToPose::Goal goal;
  goal.behavior_tree("tree");
  request.goal_id().uuid()[15] = 7;
  request.goal(goal);
  EXPECT_EQ(request.goal(), goal);
}

// Values of the ROS 2 definitions.
TEST(Interface, ConstantsAreThoseOfTheirPart) {
  EXPECT_EQ(lifecycle_msgs::msg::State_Constants::TRANSITION_STATE_ERRORPROCESSING, 15);
  EXPECT_EQ(nav2_msgs::srv::ManageLifecycleNodes_Request_Constants::CLEANUP, 6);
  EXPECT_EQ(nav_msgs::srv::LoadMap_Response_Constants::RESULT_UNDEFINED_FAILURE, 255);
  EXPECT_EQ(nav2_msgs::action::NavigateToPose_Result_Constants::NONE, 0);
  EXPECT_EQ(slam_toolbox::srv::SaveMap_Response_Constants::RESULT_NO_MAP_RECEIEVD, 1);  // spelled so there
  EXPECT_EQ(slam_toolbox::srv::SerializePoseGraph_Response_Constants::RESULT_FAILED_TO_WRITE_FILE, 255);
}

TEST(Interface, AnEmptyRequestIsOneZeroByte) {
  std::vector<std::uint8_t> bytes;
  serialize(std_srvs::srv::Trigger_Request(), bytes);
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{0, 1, 0, 0, 0}));
}

}  // namespace
}  // namespace bw::test
