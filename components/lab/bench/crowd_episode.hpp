// One drive among walkers: planner, unicycle and discs, by the closed-loop rule of the scenes' README.
// Deterministic but for the times.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "components/evaluation/judged_contact.hpp"
#include "components/lab/bench/bench_common.hpp"
#include "components/lab/bench/scene_file.hpp"
#include "components/model/planning.hpp"

namespace bw {

struct CrowdEpisode {
  std::string name;
  bool success = false;             ///< components/evaluation/success.hpp
  bool reached = false;             ///< goal reached in time
  bool collision = false;           ///< some clearance fell below the robot's radius
  bool collision_at_speed = false;  ///< and the robot was faster than 0.1 m/s then
  double time = 0.0;                ///< [s] to the goal, or the timeout
  double min_clearance = std::numeric_limits<double>::infinity();  ///< [m] centre of the robot to an edge
  double max_collision_index = 0.0;                                ///< over walkers, evaluation/theory.md 7.7
  double rms_jerk = 0.0;                                           ///< [m/s^3] of the applied commands
  int not_ok = 0;                                                  ///< cycles without a feasible trajectory
  std::vector<double> ms;                                          ///< CPU time of every planner call
  std::vector<ContactRecord> contacts;  ///< with walkers and discs; `person` is the obstacle's number from 1
  std::vector<possible::MotionState> states;  ///< at the beginning of every control period
  std::vector<JudgedContact> judged;          ///< judge_crowd() fills it
  std::vector<possible::Walk> walks;          ///< of walkers who react, in the order of the scene; else empty

  /// It failed, and success was impossible (possible/theory.md 8.10).
  bool is_excused() const { return reached && bw::is_excused(judged, static_cast<int>(contacts.size())); }
};

/// Called after every integration step: time since the start [s], pose, velocity driven.
using StepObserver = std::function<void(double time, const Pose2& pose, const Twist2& twist)>;

/// Called after every planner call: time since the start [s], what was asked and what came of it.
using PlanObserver =
    std::function<void(double time, const PlanningProblem& problem, const PlanningResult& result)>;

/// `file.closed_loop` must be set. `planner` should be new: it keeps its warm start.
CrowdEpisode drive_crowd(const Scene& scene, const SceneFile& file, LocalPlanner& planner,
                         const CpuClock& clock, const StepObserver& observer = {},
                         const PlanObserver& plan_observer = {});

}  // namespace bw
