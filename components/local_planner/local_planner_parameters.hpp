// Parameters of the local planner component: which planner, how often, how far, with what means; then each
// planner's own.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "components/local_planner/follow_path/follow_path_options.hpp"
#include "components/local_planner/planner_registry.hpp"
#include "components/model/stamped_choice.hpp"

namespace bw {

struct LocalPlannerParameters {
  std::string algorithm = "eteb";
  double controller_frequency = 10.0;
  double command_lead = 0.2;
  double max_global_plan_lookahead_dist = 6.0;
  std::int64_t max_iterations = 100;
  double max_cycle_time = 0.0;
  std::int64_t threads = 0;
  double back_off_margin = 0.15;
  StampedCmdVel enable_stamped_cmd_vel = StampedCmdVel::no;
  FollowPathOptions follow_path;
  PlannerOptions planners;

  template <class Visitor>
  void fields(Visitor& v) {
    v("algorithm", algorithm,
      {.choices = planner_names(),
       .path = true,
       .rule = planner_program_fault,
       .first = true,
       .doc = "local planner in use; a path: a program that plans"});
    v("controller_frequency", controller_frequency,
      {.unit = "Hz", .min = 1, .max = 100, .doc = "planning cycles per second"});
    v("command_lead", command_lead,
      {.unit = "s",
       .min = 0.005,
       .max = 1,
       .doc = "a command is for this long after now: latency, and what the jerk limit of motor_control holds "
              "back; raise it when the robot accelerates or brakes late"});
    v("max_global_plan_lookahead_dist", max_global_plan_lookahead_dist,
      {.unit = "m",
       .min = 0.5,
       .max = 50,
       .doc = "length of the global plan that is planned on; longer sees people earlier and costs time"});
    v("max_iterations", max_iterations,
      {.min = 1, .max = 10000, .doc = "solver iterations in one cycle, over all candidates"});
    v("max_cycle_time", max_cycle_time,
      {.unit = "s",
       .min = 0,
       .max = 1,
       .doc = "cuts max_iterations to what this time has room for; 0: half of the time between cycles; "
              "without effect in lock-step"});
    v("threads", threads,
      {.min = 0,
       .max = 64,
       .doc = "candidates planned at the same time; 0: as many as the machine has cores, 4 at most; one in "
              "lock-step"});
    v("back_off_margin", back_off_margin,
      {.unit = "m", .min = 0, .max = 2, .doc = "clearance kept behind the footprint while backing off"});
    v("enable_stamped_cmd_vel", enable_stamped_cmd_vel,
      {.doc =
           "commands are TwistStamped, no Twist; auto: as Nav2 of the graph's ros_distro has it, true from Kilted on"});
    follow_path.fields(v);
    planners.fields(v);
    v.retired({"pteb"}, "its one parameter is a constant of hrvo_preference.hpp");
  }

  std::optional<std::string> violated_rule() const { return follow_path.violated_rule(); }
};

}  // namespace bw
