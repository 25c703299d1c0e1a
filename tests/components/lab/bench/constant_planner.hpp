// A planner that says the same whatever it is asked, and keeps what it was asked.
#pragma once

#include <vector>

#include "components/model/planning.hpp"

namespace bw::test {

class ConstantPlanner final : public LocalPlanner {
 public:
  explicit ConstantPlanner(const Twist2& command) : command_(command) {}
  PlanningResult plan(const PlanningProblem& problem) override {
    problems.push_back(problem);
    PlanningResult result;
    result.status = PlanningStatus::ok;
    result.command = command_;
    return result;
  }
  void reset() override {}

  std::vector<PlanningProblem> problems;

 private:
  Twist2 command_;
};

}  // namespace bw::test
