// Local planner `hrvo`: a velocity for a robot that could move any way, followed by one that has to turn. The
// baseline that shows what the rule does on its own.
#pragma once

#include <optional>
#include <vector>

#include "components/local_planner/driving.hpp"
#include "components/local_planner/hrvo/hrvo_options.hpp"
#include "components/model/planning.hpp"

namespace bw::hrvo {

/// Each call: the advised velocity towards the point of the plan `lookahead` ahead; turn towards it, slower
/// the further it points away from the heading, never backward. Of several speeds, down to turning on the
/// spot, the highest whose motion over feasibility_check_time is free; if none is: an evasive move, then a
/// stop (status infeasible).
class HrvoPlanner final : public LocalPlanner {
 public:
  HrvoPlanner(const HrvoOptions& options, const DrivingOptions& driving)
      : options_(options), driving_(driving) {}

  PlanningResult plan(const PlanningProblem& problem) override;
  void reset() override;

 private:
  HrvoOptions options_;
  DrivingOptions driving_;
  bool arrived_ = false;
  std::optional<Vector2> last_;  ///< velocity advised
};

}  // namespace bw::hrvo
