#include "components/local_planner/iteration_budget.hpp"

#include <algorithm>
#include <cmath>

namespace bw {
namespace {

constexpr double kRate = 0.1;  // share of the newest cycle in the running means

}  // namespace

IterationBudget::IterationBudget(double cycle_time, int max_iterations)
    : cycle_time_(cycle_time), max_iterations_(std::max(max_iterations, 1)) {}

void IterationBudget::observe(int iterations, double time) {
  if (iterations <= 0 || !(time > 0.0) || !std::isfinite(time)) return;
  const double rate = mean_iterations_ > 0.0 ? kRate : 1.0;
  mean_time_ += rate * (time - mean_time_);
  mean_iterations_ += rate * (iterations - mean_iterations_);
}

int IterationBudget::iterations() const {
  if (mean_iterations_ <= 0.0) return max_iterations_;
  const double fitting = cycle_time_ * mean_iterations_ / mean_time_;
  if (!(fitting < max_iterations_)) return max_iterations_;
  return std::max(static_cast<int>(fitting), std::min(kMinIterations, max_iterations_));
}

}  // namespace bw
