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
  /// [s] a server that takes longer to say yes has not taken the goal
  static constexpr double kAcknowledgementTimeout = 1.0;
  /// [m] how far behavior_server's `backup` drives back
  static constexpr double kBackOffDistance = 0.3;
  /// [m/s] how fast
  static constexpr double kBackOffSpeed = 0.1;
  /// [s] and for how long at most
  static constexpr double kBackOffTime = 10.0;
  /// [Hz] how often follow_status is told (set by code alone)
  double rate = 10.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("planner_id", planner_id, {.doc = "of planner_server's planner_plugins; empty: the only one"});
    v("controller_id", controller_id,
      {.doc = "of controller_server's controller_plugins; empty: the only one"});
    v("goal_checker_id", goal_checker_id, {.doc = "of its goal_checker_plugins; empty: the only one"});
    v("progress_checker_id", progress_checker_id,
      {.doc = "of its progress_checker_plugins; empty: the only one; Humble knows none"});
    v.retired({"clear_costmaps"}, "they are always cleared");
  }
};

}  // namespace bw
