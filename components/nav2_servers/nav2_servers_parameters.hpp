// How Nav2's servers are asked: which of their plugins, and how far they drive back.
#pragma once

#include <string>

#include "runtime/base/field.hpp"

namespace bw {

struct Nav2ServersParameters {
  std::string planner_id;
  std::string controller_id;
  std::string goal_checker_id;
  std::string progress_checker_id;
  double acknowledgement_timeout = 1.0;
  double back_off_distance = 0.3;
  double back_off_speed = 0.1;
  double back_off_time = 10.0;
  double rate = 10.0;
  bool clear_costmaps = true;

  template <class Visitor>
  void fields(Visitor& v) {
    v("planner_id", planner_id, {.doc = "of planner_server's planner_plugins; empty: the only one"});
    v("controller_id", controller_id,
      {.doc = "of controller_server's controller_plugins; empty: the only one"});
    v("goal_checker_id", goal_checker_id, {.doc = "of its goal_checker_plugins; empty: the only one"});
    v("progress_checker_id", progress_checker_id,
      {.doc = "of its progress_checker_plugins; empty: the only one; Humble knows none"});
    v("acknowledgement_timeout", acknowledgement_timeout,
      {.unit = "s",
       .min = 0.02,
       .max = 60,
       .doc = "a server that takes longer to say yes has not taken the goal"});
    v("back_off_distance", back_off_distance,
      {.unit = "m", .min = 0.02, .max = 5, .doc = "how far behavior_server's `backup` drives back"});
    v("back_off_speed", back_off_speed, {.unit = "m/s", .min = 0.01, .max = 1, .doc = "how fast"});
    v("back_off_time", back_off_time,
      {.unit = "s", .min = 0.1, .max = 60, .doc = "and for how long at most"});
    v("rate", rate, {.unit = "Hz", .min = 2, .max = 100, .doc = "how often follow_status is told"});
    v("clear_costmaps", clear_costmaps,
      {.doc =
           "have the global costmap cleared when a plan fails, the local one when the controller gives up"});
  }
};

}  // namespace bw
