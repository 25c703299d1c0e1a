// What every local planner does before its own idea comes in: refuse what cannot be planned on, arrive at the
// goal, forget.
#pragma once

#include "components/local_planner/driving.hpp"
#include "components/model/planning.hpp"

namespace bw {

/// A planner derives from it and gives drive() and forget(). plan() answers without them when
/// - the problem is not sound (fault_of): stop, status bad_input, everything forgotten;
/// - it holds no plan: stop, status no_plan, everything forgotten;
/// - the robot is at the final goal (has_arrived): it turns to the goal heading and stands; forget() is
///   called.
class CheckedPlanner : public LocalPlanner {
 public:
  explicit CheckedPlanner(const DrivingOptions& driving) : driving_(driving) {}

  PlanningResult plan(const PlanningProblem& problem) final;
  void reset() final;
  void continue_from(const LocalPlanner& earlier) final;

 protected:
  /// The command of this cycle for a sound problem with a plan whose end is not reached yet.
  virtual PlanningResult drive(const PlanningProblem& problem) = 0;
  /// Drops what was kept from earlier calls: the next call of drive() is a first one.
  virtual void forget() = 0;
  /// Takes over what an earlier planner of the same kind has kept.
  virtual void remember(const CheckedPlanner&) {}

  const DrivingOptions& driving() const { return driving_; }

 private:
  DrivingOptions driving_;
  bool arrived_ = false;
};

}  // namespace bw
