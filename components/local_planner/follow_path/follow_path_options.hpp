// When a goal of follow_path is reached, and when it is hopeless. Names and defaults as in the
// nav2_params.yaml that Nav2 ships, but for what is said otherwise.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "components/model/goal_tolerance.hpp"
#include "runtime/base/field.hpp"

namespace bw {

/// Nav2's StoppedGoalChecker: there, and standing. The length of what is left is Lyrical's.
struct GoalCheckerOptions {
  double xy_goal_tolerance = 0.25;
  double yaw_goal_tolerance = 0.25;
  /// [s] time within the tolerances after which it counts as standing
  static constexpr double kSettleTime = 1.5;

  template <class Visitor>
  void fields(Visitor& v) {
    v("xy_goal_tolerance", xy_goal_tolerance,
      {.unit = "m", .min = 0.01, .max = 5, .doc = "distance to the end of the path that counts as there"});
    v("yaw_goal_tolerance", yaw_goal_tolerance,
      {.unit = "rad", .min = 0.01, .max = 3.15, .doc = "heading error that counts as there; 3.15: any"});
    v.retired({"settle_time"}, "a constant of follow_path_options.hpp");
  }
  GoalTolerance tolerance() const { return {xy_goal_tolerance, yaw_goal_tolerance}; }
};

/// Nav2's SimpleProgressChecker, along the path.
struct ProgressCheckerOptions {
  double required_movement_radius = 0.5;
  double movement_time_allowance = 10.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("required_movement_radius", required_movement_radius,
      {.unit = "m", .min = 0.01, .max = 10, .doc = "so far along the path is progress"});
    v("movement_time_allowance", movement_time_allowance,
      {.unit = "s", .min = 0.5, .max = 600, .doc = "longest time without progress"});
  }
};

struct FollowPathOptions {
  std::vector<std::string> controller_plugins = {"FollowPath"};
  std::vector<std::string> goal_checker_plugins = {"general_goal_checker"};
  std::vector<std::string> progress_checker_plugins = {"progress_checker"};
  std::vector<std::string> path_handler_plugins = {"PathHandler"};
  double failure_tolerance = 0.3;
  double costmap_update_timeout = 0.3;
  double max_path_deviation = 100.0;
  GoalCheckerOptions goal_checker;
  ProgressCheckerOptions progress_checker;

  template <class Visitor>
  void fields(Visitor& v) {
    v("controller_plugins", controller_plugins,
      {.doc =
           "names by which goals of follow_path may call this planner; a goal without one is taken where there is one "
           "name"});
    v("goal_checker_plugins", goal_checker_plugins, {.doc = "names of goal_checker, likewise"});
    v("progress_checker_plugins", progress_checker_plugins,
      {.doc = "names of progress_checker, likewise; none: progress is not checked"});
    v("path_handler_plugins", path_handler_plugins, {.doc = "names of the path handler (Lyrical), likewise"});
    v("failure_tolerance", failure_tolerance,
      {.unit = "s",
       .min = -1,
       .max = 600,
       .doc =
           "a goal of follow_path is given up after so long without a free way; 0: at once, -1: never; raise it in "
           "crowds"});
    v("costmap_update_timeout", costmap_update_timeout,
      {.unit = "s",
       .min = 0,
       .max = 600,
       .doc = "and after so long without a needed input or transform; meanwhile the robot stands"});
    v("max_path_deviation", max_path_deviation,
      {.unit = "m",
       .min = 0.1,
       .max = 100,
       .doc =
           "by which the straight way to the end of what is planned on may leave the path of a goal of follow_path; 0.5 follows "
           "gentle bends closely, and sees less far where the path bends around people"});
    v("goal_checker", goal_checker, {.doc = "when a goal of follow_path is reached"});
    v("progress_checker", progress_checker, {.doc = "and when it gets nowhere"});
  }

  std::optional<std::string> violated_rule() const {
    if (failure_tolerance < 0.0 && failure_tolerance != -1.0)
      return "failure_tolerance must be -1 or at least 0";
    if (controller_plugins.empty() || goal_checker_plugins.empty() || path_handler_plugins.empty())
      return "controller_plugins, goal_checker_plugins and path_handler_plugins must name one";
    return std::nullopt;
  }
};

}  // namespace bw
