// The planner that asks a planner process: one for each path with a slash that `algorithm` names.
#include <memory>
#include <string>
#include <utility>

#include <unistd.h>

#include "components/local_planner/adaptor/planner_process.hpp"
#include "components/local_planner/checked_planner.hpp"
#include "components/local_planner/command_limits.hpp"
#include "components/local_planner/planner_registry.hpp"
#include "components/model/differential_drive.hpp"

namespace bw {
namespace {

class ProcessPlanner final : public CheckedPlanner {
 public:
  ProcessPlanner(std::string program, const DrivingOptions& driving)
      : CheckedPlanner(driving), program_(std::move(program)) {}

 private:
  PlanningResult drive(const PlanningProblem& problem) override {
    if (!process_) process_ = std::make_shared<PlannerProcess>(program_);
    const Twist2 twist =
        reachable_twist(process_->ask(problem), problem.twist, problem.limits, problem.command_lead);
    PlanningResult result{.status = PlanningStatus::ok, .command = twist};
    for (const double time : {0.0, 0.25, 0.5, 0.75, 1.0})
      result.trajectory.push_back({time, advance_exact(problem.pose, twist, time), twist});
    return result;
  }
  void forget() override {}  // what it keeps is its own affair
  void remember(const CheckedPlanner& earlier) override {
    const auto* other = dynamic_cast<const ProcessPlanner*>(&earlier);
    if (other != nullptr && other->program_ == program_) process_ = other->process_;
  }

  std::string program_;
  std::shared_ptr<PlannerProcess> process_;  ///< from the first cycle on
};

std::string fault_of_program(std::string_view path) {
  return access(std::string(path).c_str(), X_OK) == 0 ? "" : "must be a program that may be executed";
}

std::unique_ptr<LocalPlanner> make_process_planner(std::string_view path, const DrivingOptions& driving) {
  return std::make_unique<ProcessPlanner>(std::string(path), driving);
}

const bool programs_are_known =
    register_planner_programs({.fault_of = fault_of_program, .make = make_process_planner});

}  // namespace
}  // namespace bw
