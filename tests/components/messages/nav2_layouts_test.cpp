// One code for all layouts: what the helpers write and read in each, and that layouts differ in nothing but
// fields.
#include "components/messages/nav2_layouts.hpp"

#include <type_traits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/messages/nav2_goals.hpp"
#include "components/messages/nav2_results.hpp"
#include "components/model/nav2_error_codes.hpp"
#include "runtime/wire/type_registry.hpp"
#include "tests/components/messages/every_nav2_message.hpp"

namespace bw::test {
namespace {

using testing::ElementsAre;

template <class Nav2>
class Nav2Layout : public testing::Test {};
using Layouts = testing::Types<HumbleNav2, JazzyNav2, KiltedNav2, LyricalNav2>;
TYPED_TEST_SUITE(Nav2Layout, Layouts);

geometry_msgs::msg::PoseStamped pose_at(double x) {
  geometry_msgs::msg::PoseStamped pose;
  pose.header().frame_id("map");
  pose.pose().position().x(x);
  return pose;
}

template <class Layout>
constexpr bool kHasCodes = !std::is_same_v<Layout, HumbleNav2>;
template <class Layout>
constexpr bool kIsLyrical = std::is_same_v<Layout, LyricalNav2>;
template <class Layout>
constexpr bool kIsKiltedOrLater = kIsLyrical<Layout> || std::is_same_v<Layout, KiltedNav2>;

TYPED_TEST(Nav2Layout, HasTheNamesOfJazzy) {
  const Messages own = every_nav2_message<TypeParam>();
  const Messages jazzys = every_nav2_message<JazzyNav2>();
  ASSERT_EQ(own.size(), jazzys.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    EXPECT_EQ(own[i]->type().ros_name, jazzys[i]->type().ros_name);
    EXPECT_EQ(own[i]->type().dds_name, jazzys[i]->type().dds_name);
  }
}

TYPED_TEST(Nav2Layout, ToolsFindItByItsHashAndByItsDistribution) {
  constexpr RosDistro kDistro = !kHasCodes<TypeParam>         ? RosDistro::humble
                                : kIsLyrical<TypeParam>       ? RosDistro::lyrical
                                : kIsKiltedOrLater<TypeParam> ? RosDistro::kilted
                                                              : RosDistro::jazzy;
  for (const auto& message : every_nav2_message<TypeParam>()) {
    const TypeDescription& own = message->type();
    EXPECT_EQ(find_type(own.ros_name, kDistro), &own) << own.ros_name;
    // What two distributions have alike has one hash.
    const TypeDescription* by_hash = find_type(own.ros_name, own.type_hash);
    ASSERT_NE(by_hash, nullptr) << own.ros_name;
    EXPECT_EQ(by_hash->type_hash, own.type_hash);
    EXPECT_EQ(by_hash->ros_name, own.ros_name);
  }
  EXPECT_EQ(find_type("nav2_msgs/action/Nothing", kDistro), nullptr);
}

TYPED_TEST(Nav2Layout, EveryResultTellsItsError) {
  const auto check = []<class Result>(Result result) {
    set_error(result, follow_path_error::kInvalidPath, "the path is empty");
    EXPECT_EQ(error_code_of(result), kHasCodes<TypeParam> ? 103 : 0);
    EXPECT_EQ(error_text_of(result), kHasCodes<TypeParam> ? "the path is empty" : "");
  };
  check(typename TypeParam::FollowPath::Result());
  check(typename TypeParam::ComputePathToPose::Result());
  check(typename TypeParam::ComputePathThroughPoses::Result());
  check(typename TypeParam::NavigateToPose::Result());
  check(typename TypeParam::NavigateThroughPoses::Result());
  check(typename TypeParam::FollowWaypoints::Result());
  check(typename TypeParam::Spin::Result());
  check(typename TypeParam::BackUp::Result());
  check(typename TypeParam::DriveOnHeading::Result());
  check(typename TypeParam::Wait::Result());
}

TYPED_TEST(Nav2Layout, PosesOfAGoalAreKept) {
  const auto check = []<class Goal>(Goal goal) {
    set_goal_poses(goal, {pose_at(1.0), pose_at(2.0)});
    EXPECT_THAT(goal_poses(goal), ElementsAre(pose_at(1.0), pose_at(2.0)));
    return goal;
  };
  const auto through = check(typename TypeParam::NavigateThroughPoses::Goal());
  if constexpr (kIsKiltedOrLater<TypeParam>) {
    EXPECT_EQ(through.poses().header().frame_id(), "map");
  }
  check(typename TypeParam::ComputePathThroughPoses::Goal());
  check(typename TypeParam::FollowWaypoints::Goal());
}

TYPED_TEST(Nav2Layout, AMissingFieldReadsAsNav2WouldActWithoutIt) {
  typename TypeParam::Spin::Goal spin;
  EXPECT_FALSE(disables_collision_checks(spin));
  if constexpr (kIsKiltedOrLater<TypeParam>) spin.disable_collision_checks(true);
  EXPECT_EQ(disables_collision_checks(spin), kIsKiltedOrLater<TypeParam>);

  typename TypeParam::FollowWaypoints::Goal waypoints;
  if constexpr (kHasCodes<TypeParam>) {
    waypoints.number_of_loops(3);
    waypoints.goal_index(2);
  }
  EXPECT_EQ(number_of_loops(waypoints), kHasCodes<TypeParam> ? 3U : 0U);
  EXPECT_EQ(first_waypoint(waypoints), kHasCodes<TypeParam> ? 2U : 0U);

  typename TypeParam::FollowPath::Goal follow;
  if constexpr (kHasCodes<TypeParam>) follow.progress_checker_id("checker");
  EXPECT_EQ(progress_checker_id(follow), kHasCodes<TypeParam> ? "checker" : "");

  typename TypeParam::ComputePathToPose::Goal plan;
  if constexpr (kIsLyrical<TypeParam>) plan.viapoints({pose_at(4.0)});
  EXPECT_EQ(via_points(plan).size(), kIsLyrical<TypeParam> ? 1U : 0U);
}

TYPED_TEST(Nav2Layout, AMissedWaypointSaysWhichAndWhy) {
  typename TypeParam::FollowWaypoints::Result result;
  add_missed_waypoint(result, 5, pose_at(3.0), 204, "outside");
  ASSERT_EQ(result.missed_waypoints().size(), 1U);
  const auto& missed = result.missed_waypoints()[0];
  if constexpr (!kHasCodes<TypeParam>) {
    EXPECT_EQ(missed, 5);
  } else if constexpr (!kIsKiltedOrLater<TypeParam>) {
    EXPECT_EQ(missed.index(), 5U);
    EXPECT_EQ(missed.goal(), pose_at(3.0));
    EXPECT_EQ(missed.error_code(), 204);
  } else {
    EXPECT_EQ(missed.waypoint_status(), nav2_msgs::msg::WaypointStatus_Constants::FAILED);
    EXPECT_EQ(missed.waypoint_index(), 5U);
    EXPECT_EQ(missed.waypoint_pose(), pose_at(3.0));
    EXPECT_EQ(missed.error_code(), 204);
    EXPECT_EQ(missed.error_msg(), "outside");
  }
}

TYPED_TEST(Nav2Layout, FeedbackOfAFollowerTellsDistanceAndSpeed) {
  typename TypeParam::FollowPath::Feedback feedback;
  set_tracking(feedback, {pose_at(1.0), 7, 2.5F, 2.25F, 0.5F, 0.125F, -0.25F});
  if constexpr (kIsLyrical<TypeParam>) {
    const auto& told = feedback.tracking_feedback();
    EXPECT_EQ(told.header().frame_id(), "map");
    EXPECT_EQ(told.robot_pose(), pose_at(1.0));
    EXPECT_EQ(told.current_path_index(), 7U);
    EXPECT_EQ(told.distance_to_goal(), 2.5F);
    EXPECT_EQ(told.remaining_path_length(), 2.25F);
    EXPECT_EQ(told.speed(), 0.5F);
    EXPECT_EQ(told.position_tracking_error(), 0.125F);
    EXPECT_EQ(told.heading_tracking_error(), -0.25F);
  } else {
    EXPECT_EQ(feedback.distance_to_goal(), 2.5F);
    EXPECT_EQ(feedback.speed(), 0.5F);
  }
}

TYPED_TEST(Nav2Layout, OnlyLyricalsAnswersHaveRoomForSuccessAndTheLastGoal) {
  typename TypeParam::ClearEntireCostmap::Response cleared;
  set_success(cleared, true);
  typename TypeParam::ComputePathThroughPoses::Result path;
  set_last_reached_index(path, -1);
  if constexpr (kIsLyrical<TypeParam>) {
    EXPECT_TRUE(cleared.success());
    EXPECT_EQ(path.last_reached_index(), -1);
  } else {
    EXPECT_EQ(cleared, typename TypeParam::ClearEntireCostmap::Response());
    EXPECT_EQ(path, typename TypeParam::ComputePathThroughPoses::Result());
  }
}

TEST(Nav2Layouts, AreChosenByDistribution) {
  const auto is = [](RosDistro distro, auto expected) {
    return with_nav2_layout(
        distro, [&](auto layout) { return std::is_same_v<decltype(layout), decltype(expected)>; });
  };
  EXPECT_TRUE(is(RosDistro::automatic, JazzyNav2()));
  EXPECT_TRUE(is(RosDistro::humble, HumbleNav2()));
  EXPECT_TRUE(is(RosDistro::jazzy, JazzyNav2()));
  EXPECT_TRUE(is(RosDistro::kilted, KiltedNav2()));
  EXPECT_TRUE(is(RosDistro::lyrical, LyricalNav2()));
}

// The codes that components use against the constants of each distribution's definitions.
TEST(Nav2ErrorCodes, AreThoseOfTheDefinitions) {
  namespace follow = lyrical::nav2_msgs::action::FollowPath_Result_Constants;
  EXPECT_EQ(kNoError, follow::NONE);
  EXPECT_EQ(kGoalRejected, follow::GOAL_REJECTED);
  EXPECT_EQ(kSendGoalFailure, follow::SEND_GOAL_FAILURE);
  EXPECT_EQ(follow_path_error::kUnknown, follow::UNKNOWN);
  EXPECT_EQ(follow_path_error::kInvalidController, follow::INVALID_CONTROLLER);
  EXPECT_EQ(follow_path_error::kTfError, follow::TF_ERROR);
  EXPECT_EQ(follow_path_error::kInvalidPath, follow::INVALID_PATH);
  EXPECT_EQ(follow_path_error::kPatienceExceeded, follow::PATIENCE_EXCEEDED);
  EXPECT_EQ(follow_path_error::kFailedToMakeProgress, follow::FAILED_TO_MAKE_PROGRESS);
  EXPECT_EQ(follow_path_error::kNoValidControl, follow::NO_VALID_CONTROL);
  EXPECT_EQ(follow_path_error::kControllerTimedOut, follow::CONTROLLER_TIMED_OUT);
  EXPECT_EQ(follow_path_error::kTimeout, follow::TIMEOUT);
  namespace plan = nav2_msgs::action::ComputePathToPose_Result_Constants;
  EXPECT_EQ(compute_path_error::kUnknown, plan::UNKNOWN);
  EXPECT_EQ(compute_path_error::kInvalidPlanner, plan::INVALID_PLANNER);
  EXPECT_EQ(compute_path_error::kTfError, plan::TF_ERROR);
  EXPECT_EQ(compute_path_error::kStartOutsideMap, plan::START_OUTSIDE_MAP);
  EXPECT_EQ(compute_path_error::kGoalOutsideMap, plan::GOAL_OUTSIDE_MAP);
  EXPECT_EQ(compute_path_error::kStartOccupied, plan::START_OCCUPIED);
  EXPECT_EQ(compute_path_error::kGoalOccupied, plan::GOAL_OCCUPIED);
  EXPECT_EQ(compute_path_error::kTimeout, plan::TIMEOUT);
  EXPECT_EQ(compute_path_error::kNoValidPath, plan::NO_VALID_PATH);
  namespace through = nav2_msgs::action::ComputePathThroughPoses_Result_Constants;
  EXPECT_EQ(compute_path_through_poses_error::kUnknown, through::UNKNOWN);
  EXPECT_EQ(compute_path_through_poses_error::kInvalidPlanner, through::INVALID_PLANNER);
  EXPECT_EQ(compute_path_through_poses_error::kTfError, through::TF_ERROR);
  EXPECT_EQ(compute_path_through_poses_error::kStartOutsideMap, through::START_OUTSIDE_MAP);
  EXPECT_EQ(compute_path_through_poses_error::kGoalOutsideMap, through::GOAL_OUTSIDE_MAP);
  EXPECT_EQ(compute_path_through_poses_error::kStartOccupied, through::START_OCCUPIED);
  EXPECT_EQ(compute_path_through_poses_error::kGoalOccupied, through::GOAL_OCCUPIED);
  EXPECT_EQ(compute_path_through_poses_error::kTimeout, through::TIMEOUT);
  EXPECT_EQ(compute_path_through_poses_error::kNoValidPath, through::NO_VALID_PATH);
  EXPECT_EQ(compute_path_through_poses_error::kNoViapointsGiven, through::NO_VIAPOINTS_GIVEN);
}

TEST(Nav2ErrorCodes, OfWaypointsBehaviorsAndNavigatorsAreThoseOfTheDefinitions) {
  namespace waypoints = kilted::nav2_msgs::action::FollowWaypoints_Result_Constants;
  EXPECT_EQ(follow_waypoints_error::kUnknown, waypoints::UNKNOWN);
  EXPECT_EQ(follow_waypoints_error::kTaskExecutorFailed, waypoints::TASK_EXECUTOR_FAILED);
  EXPECT_EQ(follow_waypoints_error::kNoValidWaypoints, waypoints::NO_VALID_WAYPOINTS);
  EXPECT_EQ(follow_waypoints_error::kStopOnMissedWaypoint, waypoints::STOP_ON_MISSED_WAYPOINT);
  namespace spin = nav2_msgs::action::Spin_Result_Constants;
  EXPECT_EQ(spin_error::kUnknown, spin::UNKNOWN);
  EXPECT_EQ(spin_error::kTimeout, spin::TIMEOUT);
  EXPECT_EQ(spin_error::kTfError, spin::TF_ERROR);
  EXPECT_EQ(spin_error::kCollisionAhead, spin::COLLISION_AHEAD);
  namespace back_up = nav2_msgs::action::BackUp_Result_Constants;
  EXPECT_EQ(back_up_error::kUnknown, back_up::UNKNOWN);
  EXPECT_EQ(back_up_error::kTimeout, back_up::TIMEOUT);
  EXPECT_EQ(back_up_error::kTfError, back_up::TF_ERROR);
  EXPECT_EQ(back_up_error::kInvalidInput, back_up::INVALID_INPUT);
  EXPECT_EQ(back_up_error::kCollisionAhead, back_up::COLLISION_AHEAD);
  namespace heading = nav2_msgs::action::DriveOnHeading_Result_Constants;
  EXPECT_EQ(drive_on_heading_error::kUnknown, heading::UNKNOWN);
  EXPECT_EQ(drive_on_heading_error::kTimeout, heading::TIMEOUT);
  EXPECT_EQ(drive_on_heading_error::kTfError, heading::TF_ERROR);
  EXPECT_EQ(drive_on_heading_error::kCollisionAhead, heading::COLLISION_AHEAD);
  EXPECT_EQ(drive_on_heading_error::kInvalidInput, heading::INVALID_INPUT);
  namespace pose = lyrical::nav2_msgs::action::NavigateToPose_Result_Constants;
  EXPECT_EQ(navigate_to_pose_error::kUnknown, pose::UNKNOWN);
  EXPECT_EQ(navigate_to_pose_error::kFailedToLoadBehaviorTree, pose::FAILED_TO_LOAD_BEHAVIOR_TREE);
  EXPECT_EQ(navigate_to_pose_error::kTfError, pose::TF_ERROR);
  EXPECT_EQ(navigate_to_pose_error::kTimeout, pose::TIMEOUT);
  namespace poses = kilted::nav2_msgs::action::NavigateThroughPoses_Result_Constants;
  EXPECT_EQ(navigate_through_poses_error::kUnknown, poses::UNKNOWN);
  EXPECT_EQ(navigate_through_poses_error::kFailedToLoadBehaviorTree, poses::FAILED_TO_LOAD_BEHAVIOR_TREE);
  EXPECT_EQ(navigate_through_poses_error::kTfError, poses::TF_ERROR);
  EXPECT_EQ(navigate_through_poses_error::kTimeout, poses::TIMEOUT);
}

}  // namespace
}  // namespace bw::test
