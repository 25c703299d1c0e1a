#include "components/local_planner/checked_planner.hpp"

#include <string>
#include <utility>

#include "components/local_planner/problem_check.hpp"

namespace bw {

PlanningResult CheckedPlanner::plan(const PlanningProblem& problem) {
  if (std::string fault = fault_of(problem); !fault.empty()) {
    reset();
    return stopped(problem, PlanningStatus::bad_input, std::move(fault));
  }
  if (problem.plan.empty()) {
    reset();
    return stopped(problem, PlanningStatus::no_plan, "the plan is empty");
  }
  arrived_ = has_arrived(problem, driving_, arrived_);
  if (!arrived_) return drive(problem);
  forget();
  return arrive(problem, driving_);
}

void CheckedPlanner::continue_from(const LocalPlanner& earlier) {
  const auto* checked = dynamic_cast<const CheckedPlanner*>(&earlier);
  if (checked == nullptr) return;
  arrived_ = checked->arrived_;
  remember(*checked);
}

void CheckedPlanner::reset() {
  arrived_ = false;
  forget();
}

}  // namespace bw
