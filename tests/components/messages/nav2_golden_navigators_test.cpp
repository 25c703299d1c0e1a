// The bytes of NavigateToPose, NavigateThroughPoses and FollowWaypoints as navigation2's branches define
// them. No program of Kilted or Lyrical has been met: what is theirs alone is unproved.
#include "components/messages/nav2_layouts.hpp"
#include "tests/components/messages/nav2_golden.hpp"

namespace bw::test {
namespace {

template <class Goal>
Golden<Goal> to_pose() {
  Goal goal;
  goal.pose(pose(7.0));
  goal.behavior_tree("tree.xml");
  return {goal, [](CdrWriter& w) {
            write_pose(w, 7.0);
            w.text("tree.xml");
          }};
}

template <class Feedback>
Feedback underway() {
  Feedback feedback;
  feedback.current_pose(pose(1.5));
  feedback.navigation_time(duration(10));
  feedback.estimated_time_remaining(duration(20));
  feedback.number_of_recoveries(2);
  feedback.distance_remaining(4.5F);
  return feedback;
}
void write_underway(CdrWriter& w) {
  write_pose(w, 1.5);
  write_duration(w, 10);
  write_duration(w, 20);
  w.put<std::int16_t>(2).floats(4.5);
}

TEST(Nav2Golden, NavigateToPoseOfHumble) {
  using Action = HumbleNav2::NavigateToPose;
  expect_action<Action>(to_pose<Action::Goal>(), {{}, write_nothing},
                        {underway<Action::Feedback>(), write_underway});
}

TEST(Nav2Golden, NavigateToPoseOfJazzy) {
  using Action = JazzyNav2::NavigateToPose;
  Action::Result result;
  fail(result, 208);
  expect_action<Action>(to_pose<Action::Goal>(), {result, [](CdrWriter& w) { write_error(w, 208); }},
                        {underway<Action::Feedback>(), write_underway});
}

TEST(Nav2GoldenUnproved, NavigateToPoseOfLyrical) {
  using Action = LyricalNav2::NavigateToPose;
  Action::Result result;
  fail(result, 9003);
  auto feedback = underway<Action::Feedback>();
  feedback.position_tracking_error(0.125F);
  feedback.heading_tracking_error(-0.5F);
  expect_action<Action>(to_pose<Action::Goal>(), {result, [](CdrWriter& w) { write_error(w, 9003); }},
                        {feedback, [](CdrWriter& w) {
                           write_underway(w);
                           w.floats(0.125, -0.5);
                         }});
}

template <class Feedback>
Feedback underway_through() {
  auto feedback = underway<Feedback>();
  feedback.number_of_poses_remaining(3);
  return feedback;
}
void write_underway_through(CdrWriter& w) {
  write_underway(w);
  w.put<std::int16_t>(3);
}
void write_one_status(CdrWriter& w) {
  w.put<std::uint32_t>(1);
  write_waypoint_status(w);
}

template <class Goal>
Golden<Goal> through_poses() {
  Goal goal;
  goal.poses(two_poses());
  goal.behavior_tree("tree.xml");
  return {goal, [](CdrWriter& w) {
            write_two_poses(w);
            w.text("tree.xml");
          }};
}
template <class Goal>
Golden<Goal> through_goals() {
  Goal goal;
  goal.poses(goals());
  goal.behavior_tree("tree.xml");
  return {goal, [](CdrWriter& w) {
            write_goals(w);
            w.text("tree.xml");
          }};
}

/// uint16 error_code, string error_msg, WaypointStatus[] waypoint_statuses
template <class Result>
Golden<Result> through_result() {
  Result result;
  fail(result, 9102);
  result.waypoint_statuses({waypoint_status()});
  return {result, [](CdrWriter& w) {
            write_error(w, 9102);
            write_one_status(w);
          }};
}

TEST(Nav2Golden, NavigateThroughPosesOfHumble) {
  using Action = HumbleNav2::NavigateThroughPoses;
  expect_action<Action>(through_poses<Action::Goal>(), {{}, write_nothing},
                        {underway_through<Action::Feedback>(), write_underway_through});
}

TEST(Nav2Golden, NavigateThroughPosesOfJazzy) {
  using Action = JazzyNav2::NavigateThroughPoses;
  Action::Result result;
  fail(result, 106);
  expect_action<Action>(through_poses<Action::Goal>(), {result, [](CdrWriter& w) { write_error(w, 106); }},
                        {underway_through<Action::Feedback>(), write_underway_through});
}

TEST(Nav2GoldenUnproved, NavigateThroughPosesOfKilted) {
  using Action = KiltedNav2::NavigateThroughPoses;
  auto feedback = underway_through<Action::Feedback>();
  feedback.waypoint_statuses({waypoint_status()});
  expect_action<Action>(through_goals<Action::Goal>(), through_result<Action::Result>(),
                        {feedback, [](CdrWriter& w) {
                           write_underway_through(w);
                           write_one_status(w);
                         }});
}

TEST(Nav2GoldenUnproved, NavigateThroughPosesOfLyrical) {
  using Action = LyricalNav2::NavigateThroughPoses;
  auto feedback = underway_through<Action::Feedback>();
  feedback.position_tracking_error(0.125F);
  feedback.heading_tracking_error(-0.5F);
  feedback.waypoint_statuses({waypoint_status()});
  expect_action<Action>(through_goals<Action::Goal>(), through_result<Action::Result>(),
                        {feedback, [](CdrWriter& w) {
                           write_underway(w);
                           w.floats(0.125, -0.5).put<std::int16_t>(3);
                           write_one_status(w);
                         }});
}

template <class Goal>
Golden<Goal> waypoints() {
  Goal goal;
  goal.number_of_loops(2);
  goal.goal_index(1);
  goal.poses(two_poses());
  return {goal, [](CdrWriter& w) {
            w.put<std::uint32_t>(2).put<std::uint32_t>(1);
            write_two_poses(w);
          }};
}
template <class Feedback>
Golden<Feedback> at_waypoint() {
  Feedback feedback;
  feedback.current_waypoint(1);
  return {feedback, [](CdrWriter& w) { w.put<std::uint32_t>(1); }};
}

TEST(Nav2Golden, FollowWaypointsOfHumble) {
  using Action = HumbleNav2::FollowWaypoints;
  Action::Goal goal;
  goal.poses(two_poses());
  Action::Result result;
  result.missed_waypoints({0, 1});
  expect_action<Action>(
      {goal, write_two_poses},
      {result, [](CdrWriter& w) { w.put<std::uint32_t>(2).put<std::int32_t>(0).put<std::int32_t>(1); }},
      at_waypoint<Action::Feedback>());
}

TEST(Nav2Golden, FollowWaypointsOfJazzy) {
  using Action = JazzyNav2::FollowWaypoints;
  Action::Result result;
  auto& missed = result.missed_waypoints().emplace_back();
  missed.index(1);
  missed.goal(pose(4.0));
  missed.error_code(204);
  fail(result, 601);
  expect_action<Action>(waypoints<Action::Goal>(),
                        {result,
                         [](CdrWriter& w) {
                           w.put<std::uint32_t>(1).put<std::uint32_t>(1);
                           write_pose(w, 4.0);
                           w.put<std::uint16_t>(204);
                           write_error(w, 601);
                         }},
                        at_waypoint<Action::Feedback>());
}

TEST(Nav2GoldenUnproved, FollowWaypointsOfKiltedAndLyrical) {
  using Action = KiltedNav2::FollowWaypoints;
  EXPECT_TRUE((std::is_same_v<Action, LyricalNav2::FollowWaypoints>));
  Action::Result result;
  result.missed_waypoints({waypoint_status()});
  fail(result, 603);
  expect_action<Action>(waypoints<Action::Goal>(),
                        {result,
                         [](CdrWriter& w) {
                           write_one_status(w);
                           write_error(w, 603);
                         }},
                        at_waypoint<Action::Feedback>());
}

}  // namespace
}  // namespace bw::test
