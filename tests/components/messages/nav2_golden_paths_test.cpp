// The bytes of FollowPath, ComputePathToPose and ComputePathThroughPoses as navigation2's branches define
// them. No program of Kilted or Lyrical has been met: what is theirs alone is unproved.
#include "components/messages/nav2_layouts.hpp"
#include "tests/components/messages/nav2_golden.hpp"

namespace bw::test {
namespace {

template <class Goal>
Goal follow_goal() {
  Goal goal;
  goal.path(path());
  goal.controller_id("FollowPath");
  goal.goal_checker_id("precise");
  return goal;
}
void write_follow_goal(CdrWriter& w) {
  write_path(w);
  w.text("FollowPath").text("precise");
}

template <class Feedback>
Golden<Feedback> follow_feedback() {
  Feedback feedback;
  feedback.distance_to_goal(2.5F);
  feedback.speed(0.25F);
  return {feedback, [](CdrWriter& w) { w.floats(2.5, 0.25); }};
}

TEST(Nav2Golden, FollowPathOfHumble) {
  using Action = HumbleNav2::FollowPath;
  expect_action<Action>({follow_goal<Action::Goal>(), write_follow_goal}, {{}, write_nothing},
                        follow_feedback<Action::Feedback>());
}

TEST(Nav2Golden, FollowPathOfJazzy) {
  using Action = JazzyNav2::FollowPath;
  auto goal = follow_goal<Action::Goal>();
  goal.progress_checker_id("slow");
  Action::Result result;
  fail(result, 105);
  expect_action<Action>({goal,
                         [](CdrWriter& w) {
                           write_follow_goal(w);
                           w.text("slow");
                         }},
                        {result,
                         [](CdrWriter& w) {
                           write_nothing(w);
                           write_error(w, 105);
                         }},
                        follow_feedback<Action::Feedback>());
}

TEST(Nav2GoldenUnproved, FollowPathOfLyrical) {
  using Action = LyricalNav2::FollowPath;
  auto goal = follow_goal<Action::Goal>();
  goal.progress_checker_id("slow");
  goal.path_handler_id("pruned");
  Action::Result result;
  fail(result, 108);
  Action::Feedback feedback;
  auto& tracking = feedback.tracking_feedback();
  tracking.header().frame_id("map");
  tracking.position_tracking_error(0.125F);
  tracking.heading_tracking_error(-0.5F);
  tracking.current_path_index(17);
  tracking.robot_pose(pose(1.0));
  tracking.distance_to_goal(2.5F);
  tracking.speed(0.25F);
  tracking.remaining_path_length(2.75F);
  expect_action<Action>({goal,
                         [](CdrWriter& w) {
                           write_follow_goal(w);
                           w.text("slow").text("pruned");
                         }},
                        {result,
                         [](CdrWriter& w) {
                           write_nothing(w);
                           write_error(w, 108);
                         }},
                        {feedback, [](CdrWriter& w) {
                           w.header(0, 0, "map").floats(0.125, -0.5).put<std::uint32_t>(17);
                           write_pose(w, 1.0);
                           w.floats(2.5, 0.25, 2.75);
                         }});
}

/// Of both planning actions, from their third field on.
template <class Goal>
void plan_with(Goal& goal) {
  goal.start(pose(5.0));
  goal.planner_id("GridBased");
  goal.use_start(true);
}
void write_plan_with(CdrWriter& w) {
  write_pose(w, 5.0);
  w.text("GridBased").put<std::uint8_t>(1);
}

template <class Result>
Result planned() {
  Result result;
  result.path(path());
  result.planning_time(duration(3));
  return result;
}
void write_planned(CdrWriter& w) {
  write_path(w);
  write_duration(w, 3);
}
void write_planned_with_error(CdrWriter& w, std::uint16_t code) {
  write_planned(w);
  write_error(w, code);
}

TEST(Nav2Golden, ComputePathToPoseOfHumble) {
  using Action = HumbleNav2::ComputePathToPose;
  Action::Goal goal;
  goal.goal(pose(6.0));
  plan_with(goal);
  expect_action<Action>({goal,
                         [](CdrWriter& w) {
                           write_pose(w, 6.0);
                           write_plan_with(w);
                         }},
                        {planned<Action::Result>(), write_planned}, {{}, write_nothing});
}

TEST(Nav2Golden, ComputePathToPoseOfJazzy) {
  using Action = JazzyNav2::ComputePathToPose;
  Action::Goal goal;
  goal.goal(pose(6.0));
  plan_with(goal);
  auto result = planned<Action::Result>();
  fail(result, 206);
  expect_action<Action>({goal,
                         [](CdrWriter& w) {
                           write_pose(w, 6.0);
                           write_plan_with(w);
                         }},
                        {result, [](CdrWriter& w) { write_planned_with_error(w, 206); }},
                        {{}, write_nothing});
}

TEST(Nav2GoldenUnproved, ComputePathToPoseOfLyrical) {
  using Action = LyricalNav2::ComputePathToPose;
  Action::Goal goal;
  goal.goal(pose(6.0));
  plan_with(goal);
  goal.viapoints(two_poses());
  auto result = planned<Action::Result>();
  fail(result, 208);
  expect_action<Action>({goal,
                         [](CdrWriter& w) {
                           write_pose(w, 6.0);
                           write_pose(w, 5.0);
                           write_two_poses(w);
                           w.text("GridBased").put<std::uint8_t>(1);
                         }},
                        {result, [](CdrWriter& w) { write_planned_with_error(w, 208); }},
                        {{}, write_nothing});
}

TEST(Nav2Golden, ComputePathThroughPosesOfHumble) {
  using Action = HumbleNav2::ComputePathThroughPoses;
  Action::Goal goal;
  goal.goals(two_poses());
  plan_with(goal);
  expect_action<Action>({goal,
                         [](CdrWriter& w) {
                           write_two_poses(w);
                           write_plan_with(w);
                         }},
                        {planned<Action::Result>(), write_planned}, {{}, write_nothing});
}

TEST(Nav2Golden, ComputePathThroughPosesOfJazzy) {
  using Action = JazzyNav2::ComputePathThroughPoses;
  Action::Goal goal;
  goal.goals(two_poses());
  plan_with(goal);
  auto result = planned<Action::Result>();
  fail(result, 309);
  expect_action<Action>({goal,
                         [](CdrWriter& w) {
                           write_two_poses(w);
                           write_plan_with(w);
                         }},
                        {result, [](CdrWriter& w) { write_planned_with_error(w, 309); }},
                        {{}, write_nothing});
}

TEST(Nav2GoldenUnproved, ComputePathThroughPosesOfKilted) {
  using Action = KiltedNav2::ComputePathThroughPoses;
  Action::Goal goal;
  goal.goals(goals());
  plan_with(goal);
  auto result = planned<Action::Result>();
  fail(result, 309);
  expect_action<Action>({goal,
                         [](CdrWriter& w) {
                           write_goals(w);
                           write_plan_with(w);
                         }},
                        {result, [](CdrWriter& w) { write_planned_with_error(w, 309); }},
                        {{}, write_nothing});
}

TEST(Nav2GoldenUnproved, ComputePathThroughPosesOfLyrical) {
  using Action = LyricalNav2::ComputePathThroughPoses;
  Action::Goal goal;
  goal.goals(goals());
  plan_with(goal);
  auto result = planned<Action::Result>();
  fail(result, 308);
  result.last_reached_index(-1);
  expect_action<Action>({goal,
                         [](CdrWriter& w) {
                           write_goals(w);
                           write_plan_with(w);
                         }},
                        {result,
                         [](CdrWriter& w) {
                           write_path(w);
                           w.put<std::int16_t>(-1);
                           write_duration(w, 3);
                           write_error(w, 308);
                         }},
                        {{}, write_nothing});
}

}  // namespace
}  // namespace bw::test
