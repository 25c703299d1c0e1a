#include "components/local_planner/adaptor/cycle_watch.hpp"

#include <fmt/format.h>

namespace bw {

CycleWatch::CycleWatch(double period, double time_allowed, int max_iterations, bool real_time)
    : period_(period),
      max_iterations_(max_iterations),
      real_time_(real_time),
      iteration_budget_(time_allowed, max_iterations) {}

Budget CycleWatch::budget() const {
  return {.max_iterations = real_time_ ? iteration_budget_.iterations() : max_iterations_};
}

void CycleWatch::begin() {
  if (real_time_) began_ = steady_time();
}

void CycleWatch::end(const PlanningResult& result) {
  if (!real_time_) return;
  const Duration time = steady_time() - began_;
  times_.add(time);
  if (time.to_seconds() > period_) ++overruns_;
  iteration_budget_.observe(result.iterations, time.to_seconds());
}

void CycleWatch::report(const PlanningResult& result, bool idle, DiagnosticReporter& diagnostics) const {
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
  if (!real_time_) return;
  diagnostics.set_value("cycle_p95_ms", fmt::format("{:.2f}", times_.quantile_ms(0.95)));
  diagnostics.set_value("cycle_max_ms", fmt::format("{:.2f}", times_.max().to_seconds() * 1e3));
  diagnostics.set_value("overruns", fmt::to_string(overruns_));
}

}  // namespace bw
