#include "components/local_planner/problem_check.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace bw {
namespace {

PlanningProblem sound() {
  PlanningProblem problem;
  problem.plan = {{0, 0, 0}, {3, 0, 0}};
  return problem;
}

TEST(FaultOf, FindsNoneInASoundProblem) {
  PlanningProblem problem = sound();
  EXPECT_EQ(fault_of(problem), "");
  problem.footprint = {0.5, {{-0.4, -0.3}, {0.4, -0.3}, {0.4, 0.3}, {-0.4, 0.3}}};  // hypot(0.4, 0.3) = 0.5
  EXPECT_EQ(fault_of(problem), "");
  problem.limits.v_back_max = 0.0;
  EXPECT_EQ(fault_of(problem), "");
}

TEST(FaultOf, RefusesPeriodsInWhichNothingCanBeControlled) {
  // Motions are simulated in steps of the lead: 1e-12 s of them would fill the memory.
  for (const double period : {0.0, -0.1, 1e-12, 4e-3, 1e6, HUGE_VAL, std::nan("")}) {
    PlanningProblem problem = sound();
    problem.command_lead = period;
    EXPECT_EQ(fault_of(problem), "the command lead is not between 5 ms and 10 s") << period;
    problem = sound();
    problem.control_period = period;
    EXPECT_EQ(fault_of(problem), "the control period is not between 5 ms and 10 s") << period;
  }
}

TEST(FaultOf, RefusesPredictionsThatNeedAnInfiniteVelocity) {
  // 1 m in 1e-300 s: where the mover is after that would not be finite.
  PlanningProblem problem = sound();
  Mover mover;
  mover.predictions = {{1e-300, {1.0, 0.0}, Eigen::Matrix2d::Zero()}};
  problem.movers = {mover};
  EXPECT_NE(fault_of(problem), "");
  problem.movers[0].predictions = {{0.0, {1.0, 0.0}, Eigen::Matrix2d::Zero()},  // of now: not used
                                   {0.5, {1.0, 0.0}, Eigen::Matrix2d::Zero()}};
  EXPECT_EQ(fault_of(problem), "");
}

TEST(FaultOf, RefusesAFootprintThatItsRadiusDoesNotEnclose) {
  // Bands and velocity obstacles know the radius only.
  PlanningProblem problem = sound();
  problem.footprint = {0.3, {{-0.4, -0.3}, {0.4, -0.3}, {0.4, 0.3}, {-0.4, 0.3}}};
  EXPECT_EQ(fault_of(problem), "a footprint corner is outside its radius");
}

}  // namespace
}  // namespace bw
