// Times the planning cycles where time is real: the budget of the next one, and figures for /diagnostics. In
// lock-step it reads no clock, and the budget is what the parameters say.
#pragma once

#include <cstdint>

#include <bandwagon_msgs/msg/planner_cycle.hpp>

#include "components/local_planner/iteration_budget.hpp"
#include "components/model/planning.hpp"
#include "runtime/component.hpp"
#include "runtime/host/statistics.hpp"

namespace bw {

class CycleWatch {
 public:
  /// `period` [s] between cycles; `time_allowed` [s] in which one should end.
  CycleWatch(double period, double time_allowed, int max_iterations, bool real_time);

  /// For the cycle that begins.
  Budget budget() const;
  void begin();
  /// The cycle as a message, with what it took until now; header and planner are the caller's.
  bandwagon_msgs::msg::PlannerCycle message(const PlanningResult& result, bool idle) const;
  /// Not called for a cycle that had nothing to plan.
  void end(const PlanningResult& result);
  /// The state of the planner and its figures, those of time up to the last cycle that ended.
  void report(const PlanningResult& result, bool idle, DiagnosticReporter& diagnostics);

 private:
  double period_;
  double time_allowed_;
  int max_iterations_;
  bool real_time_;
  IterationBudget iteration_budget_;
  Duration began_;
  Duration cpu_began_;
  DurationHistogram times_;  ///< of the whole run, by the steady clock: workers and waiting included
  std::uint64_t overruns_ = 0;
  bool has_left_out_ = false;  ///< any obstacle: the figure is among the others from then on
};

}  // namespace bw
