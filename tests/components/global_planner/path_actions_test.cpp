// Nav2's path actions in lock-step, and plan requests through several poses. What comes of a goal is what
// planner_server of navigation2 makes of it; the codes are those of its action definitions.
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/messages/nav2_goals.hpp"
#include "components/messages/nav2_layouts.hpp"
#include "components/messages/nav2_results.hpp"
#include "tests/components/global_planner/planner_rig.hpp"

namespace bw {
namespace {

using geometry_msgs::msg::PoseStamped;
using ToPose = JazzyNav2::ComputePathToPose;
using ThroughPoses = JazzyNav2::ComputePathThroughPoses;
using testing::HasSubstr;

PoseStamped pose(double x, double y, const std::string& frame = "map", double seconds = 0.0) {
  PoseStamped stamped;
  stamped.header(
      make_header(frame, seconds == 0.0 ? Time{} : LockstepRunner::kStart + Duration::seconds(seconds)));
  stamped.pose(to_pose({x, y, 0.0}));
  return stamped;
}

/// How often a goal was acknowledged and ended, and how.
template <class A>
struct End {
  int acknowledged = 0;
  int ended = 0;
  GoalStatus status = GoalStatus::unknown;
  typename A::Result result;
};

/// All goals at once, 0.55 s after the start.
template <class A>
std::vector<End<A>> ends_of(const PlannerWorld& world, const std::string& name,
                            const std::vector<typename A::Goal>& goals) {
  std::vector<End<A>> ends(goals.size());
  run_planner(world, [&](bw::Setup& setup) {
    setup.every(
        Duration::milliseconds(550), "goals", [&, client = setup.action_client<A>(name)](const Tick& tick) {
          for (std::size_t i = 0; tick.sequence == 0 && i < goals.size(); ++i) {
            End<A>& end = ends[i];
            client.send(goals[i], Duration::milliseconds(1000),
                        {.on_acknowledged = [&end](bool accepted,
                                                   const Tick&) { end.acknowledged += accepted ? 1 : 0; },
                         .on_result =
                             [&end](GoalStatus status, const typename A::Result* result, const Tick&) {
                               ++end.ended;
                               end.status = status;
                               if (result != nullptr) end.result = *result;
                             }});
          }
        });
  });
  for (const End<A>& end : ends) {
    EXPECT_EQ(end.acknowledged, 1);
    EXPECT_EQ(end.ended, 1);
  }
  return ends;
}

template <class Goal = ToPose::Goal>
Goal to(const PoseStamped& where, const std::string& planner_id = "") {
  Goal goal;
  goal.goal(where);
  goal.planner_id(planner_id);
  return goal;
}

ToPose::Goal from_to(const PoseStamped& start, const PoseStamped& where) {
  ToPose::Goal goal = to(where);
  goal.start(start);
  goal.use_start(true);
  return goal;
}

template <class Goal = ThroughPoses::Goal>
Goal through(const PosesStamped& poses) {
  Goal goal;
  set_goal_poses(goal, poses);
  return goal;
}

Vector2 at(const nav_msgs::msg::Path& path, std::size_t i) {
  return from_pose(path.poses().at(i).pose()).position();
}

TEST(PathActions, APathIsFoundFromTheRobotOrFromAStart) {
  const auto ends = ends_of<ToPose>(
      {}, "compute_path_to_pose",
      {to(pose(4.0, 3.0)), to(pose(4.0, 3.0), "GridBased"), from_to(pose(2.0, 1.0), pose(2.0, 5.0)),
       // In odom, which is rotated by a right angle at (1, 3): (2, 3). Known at 0.5 s, asked for at 0.2 s
       // after it.
       to(pose(0.0, -1.0, "odom", 0.5)), to(pose(0.0, -1.0, "odom")), to(pose(0.0, -1.0, "odom", 0.7))});
  for (const auto& end : ends) {
    EXPECT_EQ(end.status, GoalStatus::succeeded) << end.result.error_msg();
    EXPECT_EQ(end.result.error_code(), 0);
    EXPECT_EQ(end.result.path().header().frame_id(), "map");
    EXPECT_EQ(end.result.planning_time().nanosec(), 0U) << "nothing measured enters a sample of lock-step";
  }
  const auto& whole = ends[0].result.path();
  ASSERT_EQ(whole.poses().size(), 31U);  // 3 m by 0.1 m
  EXPECT_NEAR((at(whole, 0) - Vector2(1.0, 3.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((at(whole, 30) - Vector2(4.0, 3.0)).norm(), 0.0, 1e-9);
  EXPECT_EQ(ends[1].result.path().poses().size(), 31U);
  EXPECT_NEAR((at(ends[2].result.path(), 0) - Vector2(2.0, 1.0)).norm(), 0.0, 1e-9);
  for (const std::size_t i : {3U, 4U, 5U}) {
    const auto& path = ends[i].result.path();
    EXPECT_NEAR((at(path, path.poses().size() - 1) - Vector2(2.0, 3.0)).norm(), 0.0, 1e-9);
  }
}

struct BadGoal {
  ToPose::Goal goal;
  std::uint16_t code;
  std::string sentence;
};

TEST(PathActions, WhatIsNoGoalEndsAbortedWithACodeAndASentence) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  PoseStamped no_rotation = pose(2.0, 3.0);
  no_rotation.pose().orientation().w(0.0);
  const std::vector<BadGoal> bad = {
      {to(pose(2.0, 3.0), "Smac"), 201, "planner_id 'Smac' is none of this server: GridBased"},
      {to(pose(2.0, 3.0, "elsewhere")), 202,
       "the goal is in frame 'elsewhere', which no transform joins to 'map'"},
      {to(pose(0.0, -1.0, "odom", -60.0)), 202, "and where 'odom' was then is not known"},
      {to(pose(0.0, -1.0, "odom", 60.0)), 202, "and where 'odom' was then is not known"},
      {from_to(pose(2.0, 3.0, "elsewhere"), pose(2.0, 3.0)), 202, "the start is in frame 'elsewhere'"},
      {from_to(pose(-1.0, 3.0), pose(2.0, 3.0)), 203, "start (-1.00, 3.00) is off the map"},
      {from_to(pose(kNan, 3.0), pose(2.0, 3.0)), 202, "the start is no pose: the position is not finite"},
      {to(pose(11.0, 3.0)), 204, "goal (11.00, 3.00) is off the map"},
      {to(pose(kNan, 3.0)), 202, "pose 1 of 1 is none: the position is not finite"},
      {to(no_rotation), 202, "pose 1 of 1 is none: the quaternion has length 0"},
      {from_to(pose(9.0, 5.0), pose(2.0, 3.0)), 205, "start (9.00, 5.00) is too close to an obstacle"},
      {to(pose(5.05, 3.0)), 206, "goal (5.05, 3.00) is too close to an obstacle"},
      {to(pose(9.0, 3.0)), 208, "goal (9.00, 3.00) is free, but no way leads there"},
      // Where a map stamps a pose does not matter.
      {to(pose(2.0, 3.0, "map", 60.0)), 0, ""},
  };
  std::vector<ToPose::Goal> goals;
  for (const BadGoal& one : bad) goals.push_back(one.goal);
  const auto ends = ends_of<ToPose>({}, "compute_path_to_pose", goals);
  for (std::size_t i = 0; i < bad.size(); ++i) {
    EXPECT_EQ(ends[i].status, bad[i].code == 0 ? GoalStatus::succeeded : GoalStatus::aborted) << i;
    EXPECT_EQ(ends[i].result.error_code(), bad[i].code) << i;
    EXPECT_THAT(ends[i].result.error_msg(), HasSubstr(bad[i].sentence)) << i;
    EXPECT_EQ(ends[i].result.path().poses().empty(), bad[i].code != 0) << i;
  }
}

TEST(PathActions, WithoutAMapOrAPlaceThereIsNoPath) {
  const auto no_map = ends_of<ToPose>({.has_map = false}, "compute_path_to_pose", {to(pose(2.0, 3.0))});
  EXPECT_EQ(no_map[0].result.error_code(), 207);
  EXPECT_EQ(no_map[0].result.error_msg(), "there is no map yet");
  const auto no_pose =
      ends_of<ToPose>({.knows_its_pose = false}, "compute_path_to_pose", {to(pose(2.0, 3.0))});
  EXPECT_EQ(no_pose[0].result.error_code(), 202);
  EXPECT_EQ(no_pose[0].result.error_msg(),
            "the robot's place is not known: no transform from base_link to map");
}

TEST(PathActions, ThroughPosesItIsOnePath) {
  const PosesStamped too_many(1001, pose(2.0, 3.0));
  const auto ends =
      ends_of<ThroughPoses>({}, "compute_path_through_poses",
                            {through({pose(1.0, 5.0), pose(3.0, 5.0), pose(3.0, 3.0)}), through({}),
                             through({pose(2.0, 3.0), pose(9.0, 3.0)}), through(too_many)});
  EXPECT_EQ(ends[0].status, GoalStatus::succeeded) << ends[0].result.error_msg();
  const auto& path = ends[0].result.path();
  ASSERT_EQ(path.poses().size(), 61U);  // three legs of 2 m
  EXPECT_NEAR((at(path, 20) - Vector2(1.0, 5.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((at(path, 40) - Vector2(3.0, 5.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((at(path, 60) - Vector2(3.0, 3.0)).norm(), 0.0, 1e-9);
  for (const std::size_t i : {1U, 2U, 3U}) EXPECT_EQ(ends[i].status, GoalStatus::aborted);
  EXPECT_EQ(ends[1].result.error_code(), 309);
  EXPECT_EQ(ends[2].result.error_code(), 308);
  EXPECT_THAT(ends[2].result.error_msg(), HasSubstr("on the way to pose 2 of 2: goal (9.00, 3.00)"));
  EXPECT_EQ(ends[3].result.error_code(), 300);
  EXPECT_THAT(ends[3].result.error_msg(), HasSubstr("names 1001 poses, at most 1000"));
}

TEST(PathActions, HumbleHasTheStatusAlone) {
  using Humble = HumbleNav2::ComputePathToPose;
  const auto ends = ends_of<Humble>({.distro = "humble"}, "compute_path_to_pose",
                                    {to<Humble::Goal>(pose(4.0, 3.0)), to<Humble::Goal>(pose(9.0, 3.0))});
  EXPECT_EQ(ends[0].status, GoalStatus::succeeded);
  EXPECT_EQ(ends[0].result.path().poses().size(), 31U);
  EXPECT_EQ(ends[1].status, GoalStatus::aborted);
}

TEST(PathActions, KiltedAndLyricalHaveTheirFields) {
  using Kilted = KiltedNav2::ComputePathThroughPoses;
  const auto kilted = ends_of<Kilted>({.distro = "kilted"}, "compute_path_through_poses",
                                      {through<Kilted::Goal>({pose(1.0, 5.0), pose(3.0, 5.0)})});
  EXPECT_EQ(kilted[0].result.path().poses().size(), 41U);
  using Lyrical = LyricalNav2::ComputePathThroughPoses;
  const auto lyrical = ends_of<Lyrical>({.distro = "lyrical"}, "compute_path_through_poses",
                                        {through<Lyrical::Goal>({pose(1.0, 5.0), pose(3.0, 5.0)})});
  EXPECT_EQ(lyrical[0].result.path().poses().size(), 41U);
  EXPECT_EQ(lyrical[0].result.last_reached_index(), -1);
  using LyricalToPose = LyricalNav2::ComputePathToPose;
  auto via = to<LyricalToPose::Goal>(pose(3.0, 3.0));
  via.viapoints({pose(1.0, 5.0), pose(3.0, 5.0)});
  const auto passed = ends_of<LyricalToPose>({.distro = "lyrical"}, "compute_path_to_pose", {via});
  EXPECT_EQ(passed[0].result.path().poses().size(), 61U);
}

TEST(PathActions, FiftyGoalsAtOnceEndOnceEach) {
  const auto ends =
      ends_of<ToPose>({}, "compute_path_to_pose", std::vector<ToPose::Goal>(50, to(pose(4.0, 3.0))));
  for (const auto& end : ends) EXPECT_EQ(end.status, GoalStatus::succeeded);
}

// What the planner answers to `request`, asked once.
std::vector<bandwagon_msgs::msg::PlanResult> answers_to(const bandwagon_msgs::msg::PlanRequest& request,
                                                        const PlannerWorld& world) {
  std::vector<bandwagon_msgs::msg::PlanResult> results;
  run_planner(world, [&](bw::Setup& setup) {
    setup.input<bandwagon_msgs::msg::PlanResult>("plan_result", Qos::standard(),
                                                 [&](const auto& m, const Tick&) { results.push_back(m); });
    setup.every(
        Duration::milliseconds(550), "ask",
        [request, out = setup.output<bandwagon_msgs::msg::PlanRequest>("plan_request")](const Tick& tick) {
          if (tick.sequence == 0) out.publish(request);
        });
  });
  return results;
}

TEST(PlanRequests, GoThroughViaPoses) {
  bandwagon_msgs::msg::PlanRequest request;
  request.id(7);
  request.via_poses({pose(1.0, 5.0), pose(3.0, 5.0)});
  request.goal(pose(3.0, 3.0));
  const auto results = answers_to(request, {});
  ASSERT_EQ(results.size(), 1U);
  EXPECT_EQ(results[0].id(), 7U);
  EXPECT_EQ(results[0].status(), bandwagon_msgs::msg::PlanResult_Constants::SUCCEEDED) << results[0].reason();
  EXPECT_EQ(results[0].path().poses().size(), 61U);
}

// The navigator may know a pose before the first transform is here: no reason to give up a goal.
TEST(PlanRequests, MayBeAskedAgainWhileThePlaceIsNotKnown) {
  bandwagon_msgs::msg::PlanRequest request;
  request.goal(pose(3.0, 3.0));
  const auto results = answers_to(request, {.knows_its_pose = false});
  ASSERT_EQ(results.size(), 1U);
  EXPECT_EQ(results[0].status(), bandwagon_msgs::msg::PlanResult_Constants::FAILED);
  EXPECT_EQ(results[0].reason(), "the robot's place is not known: no transform from base_link to map");
}

}  // namespace
}  // namespace bw
