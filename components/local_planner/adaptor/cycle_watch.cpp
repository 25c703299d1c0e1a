#include "components/local_planner/adaptor/cycle_watch.hpp"

#include <limits>

#include <fmt/format.h>

namespace bw {
namespace {

std::uint8_t status_of(PlanningStatus status) {
  namespace value = bandwagon_msgs::msg::PlannerCycle_Constants;
  switch (status) {
    case PlanningStatus::ok:
      return value::OK;
    case PlanningStatus::no_plan:
      return value::NO_PLAN;
    case PlanningStatus::bad_input:
      return value::BAD_INPUT;
    case PlanningStatus::infeasible:
      break;
  }
  return value::INFEASIBLE;
}

}  // namespace

CycleWatch::CycleWatch(double period, double time_allowed, int max_iterations, bool real_time)
    : period_(period),
      time_allowed_(time_allowed),
      max_iterations_(max_iterations),
      real_time_(real_time),
      iteration_budget_(time_allowed, max_iterations) {}

Budget CycleWatch::budget() const {
  return {.max_iterations = real_time_ ? iteration_budget_.iterations() : max_iterations_};
}

void CycleWatch::begin() {
  if (!real_time_) return;
  began_ = steady_time();
  cpu_began_ = thread_cpu_time();
}

bandwagon_msgs::msg::PlannerCycle CycleWatch::message(const PlanningResult& result, bool idle) const {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  bandwagon_msgs::msg::PlannerCycle cycle;
  cycle.status(idle ? bandwagon_msgs::msg::PlannerCycle_Constants::IDLE : status_of(result.status));
  cycle.reason(idle ? "" : result.reason);
  cycle.chosen_cost(kUnknown);
  for (const Candidate& candidate : result.candidates) {
    if (!candidate.chosen) continue;
    cycle.chosen_label(candidate.label);
    cycle.chosen_cost(candidate.cost);
  }
  cycle.class_switched(result.class_switched);
  cycle.number_of_candidates(static_cast<std::uint32_t>(result.candidates.size()));
  cycle.iterations(static_cast<std::uint32_t>(result.iterations));
  cycle.iteration_budget(static_cast<std::uint32_t>(budget().max_iterations));
  cycle.duration_ms(real_time_ ? (thread_cpu_time() - cpu_began_).to_seconds() * 1e3 : kUnknown);
  cycle.budget_ms(time_allowed_ * 1e3);
  cycle.period_ms(period_ * 1e3);
  return cycle;
}

void CycleWatch::end(const PlanningResult& result) {
  if (!real_time_) return;
  const Duration time = steady_time() - began_;
  times_.add(time);
  if (time.to_seconds() > period_) ++overruns_;
  iteration_budget_.observe(result.iterations, time.to_seconds());
}

void CycleWatch::report(const PlanningResult& result, bool idle, DiagnosticReporter& diagnostics) {
  using Level = DiagnosticReporter::Level;
  if (idle) {
    diagnostics.report(Level::ok, "idle");
  } else if (result.status == PlanningStatus::ok) {
    diagnostics.report(Level::ok, result.reason.empty() ? "following" : result.reason);
  } else {
    diagnostics.report(Level::warn, result.reason);
  }
  diagnostics.set_value("candidates", fmt::to_string(result.candidates.size()));
  diagnostics.set_value("iterations", fmt::to_string(result.iterations));
  diagnostics.set_value("iteration_budget", fmt::to_string(budget().max_iterations));
  if (result.obstacles_left_out > 0 || has_left_out_) {
    diagnostics.set_value("obstacles_left_out", fmt::to_string(result.obstacles_left_out));
    has_left_out_ = true;
  }
  if (!real_time_) return;
  diagnostics.set_value("cycle_p95_ms", fmt::format("{:.2f}", times_.quantile_ms(0.95)));
  diagnostics.set_value("cycle_max_ms", fmt::format("{:.2f}", times_.max().to_seconds() * 1e3));
  diagnostics.set_value("overruns", fmt::to_string(overruns_));
}

}  // namespace bw
