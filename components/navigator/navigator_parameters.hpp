// What the graph says of the navigator beyond its judgements: where to go, how often to look.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "components/navigator/goal_list.hpp"
#include "components/navigator/navigator_options.hpp"
#include "runtime/base/choice.hpp"

namespace bw {

/// Where to go, in map.
struct ListedGoal {
  double x = 0.0;
  double y = 0.0;
  double theta = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("x", x, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "in map"});
    v("y", y, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "in map"});
    v("theta", theta, {.unit = "rad", .min = -3.1416, .max = 3.1416, .doc = "heading in map"});
  }
};

/// The one goal of a graph, and when goals of the graph begin.
struct GoalParameters : ListedGoal {
  bool enabled = false;
  double delay = 1.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("enabled", enabled, {.doc = "drive to this goal after the start; otherwise wait for goal_pose"});
    ListedGoal::fields(v);
    v("delay", delay,
      {.unit = "s",
       .min = 0,
       .max = 3600,
       .doc = "time after the start before the goal is taken up, and never before the pose is known"});
  }
};

enum class PoseSource { localization, tf };
constexpr auto choice_table(PoseSource) {
  return choices<PoseSource>({{PoseSource::localization, "localization"}, {PoseSource::tf, "tf"}});
}

struct NavigatorParameters : NavigatorOptions {
  /// [Hz] how many times a second the navigator looks at the drive (set by code alone)
  double rate = 20.0;
  /// [s] time between two status messages while driving
  static constexpr double kFeedbackPeriod = 0.2;
  PoseSource pose_source = PoseSource::localization;
  bool follow_waypoints = true;
  GoalParameters goal;
  std::vector<ListedGoal> goals;
  double waypoint_pause = 1.0;
  int number_of_loops = 0;
  bool stop_on_failure = true;

  template <class Visitor>
  void fields(Visitor& v) {
    NavigatorOptions::fields(v);
    v("pose_source", pose_source,
      {.doc =
           "localization: odometry/filtered; tf: base_link in map by tf and the speed of odom, as Nav2's servers have it"});
    v("follow_waypoints", follow_waypoints,
      {.doc =
           "offer that action; false where Nav2's waypoint_follower does, which drives by navigate_to_pose"});
    v("goal", goal, {.doc = "a goal of the graph itself"});
    v("goals", goals, {.doc = "several, driven one after the other, the first after goal.delay"});
    v("waypoint_pause", waypoint_pause,
      {.unit = "s",
       .min = 0,
       .max = 3600,
       .doc = "from the end of one of several goals to the next, of follow_waypoints too"});
    v("number_of_loops", number_of_loops,
      {.min = 0, .max = 1'000'000, .doc = "how often all the goals are driven again"});
    v("stop_on_failure", stop_on_failure,
      {.doc = "of several goals one that is not reached is the last, of follow_waypoints too; otherwise "
              "the next one is tried"});
    v.retired({"rate", "feedback_period"}, "a constant of navigator_parameters.hpp");
    v.retired({"pose_timeout"}, "a constant of planning_inputs.hpp");
    v.retired({"via_radius", "replan_period", "lost_patience"}, "a constant of navigator_options.hpp");
  }

  std::optional<std::string> violated_rule() const {
    if (goal.enabled && !goals.empty()) return "goal.enabled must be false where there are goals";
    return NavigatorOptions::violated_rule();
  }

  GoalListOptions goal_list() const {
    GoalListOptions list{.delay = goal.delay,
                         .pause = waypoint_pause,
                         .loops = static_cast<std::uint32_t>(number_of_loops),
                         .stop_on_failure = stop_on_failure};
    if (goal.enabled) list.goals.push_back({goal.x, goal.y, goal.theta});
    for (const ListedGoal& g : goals) list.goals.push_back({g.x, g.y, g.theta});
    return list;
  }
};

}  // namespace bw
