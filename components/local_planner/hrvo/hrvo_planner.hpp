// Local planner `hrvo`: a velocity for a robot that could move any way, followed by one that has to turn. The
// baseline that shows what the rule does on its own.
#pragma once

#include <optional>
#include <vector>

#include "components/local_planner/checked_planner.hpp"
#include "components/local_planner/hrvo/hrvo_options.hpp"
#include "components/model/planning.hpp"

namespace bw::hrvo {

/// Each call: the advised velocity towards the point of the plan `lookahead` ahead; turn towards it, slower
/// the further it points away from the heading, never backward. Of several speeds, down to turning on the
/// spot, the highest whose motion over feasibility_check_time is free; if none is: an evasive move, then a
/// stop (status infeasible).
class HrvoPlanner final : public CheckedPlanner {
 public:
  HrvoPlanner(const HrvoOptions& options, const DrivingOptions& driving)
      : CheckedPlanner(driving), options_(options) {}

 private:
  PlanningResult drive(const PlanningProblem& problem) override;
  void forget() override { last_.reset(); }
  void remember(const CheckedPlanner& earlier) override {
    if (const auto* other = dynamic_cast<const HrvoPlanner*>(&earlier)) last_ = other->last_;
  }

  HrvoOptions options_;
  std::optional<Vector2> last_;  ///< velocity advised
};

}  // namespace bw::hrvo
