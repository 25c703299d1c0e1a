#include "components/behaviors/behavior_goals.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "components/behaviors/travel.hpp"

namespace bw {
namespace {

class Refused final : public Behavior {
 public:
  Refused(BehaviorError error, std::string text) : step_(failed(error, std::move(text))) {}
  BehaviorStep step(const BehaviorSituation&) override { return step_; }

 private:
  BehaviorStep step_;
};

std::string fault_of(const DriveGoal& goal, const Limits& limits) {
  if (!goal.target.allFinite() || !std::isfinite(goal.target_z)) return "the target is not finite";
  if (!std::isfinite(goal.speed)) return "the speed is not finite";
  if (goal.target.y() != 0.0 || goal.target_z != 0.0)
    return "target.y and target.z must be 0: only x is driven";
  if ((goal.target.x() > 0.0) != (goal.speed > 0.0)) return "target.x and speed must have the same sign";
  if (goal.target.x() != 0.0 && goal.speed == 0.0) return "the speed must not be 0";
  if (goal.target.x() < 0.0 && limits.v_back_max <= 0.0) return "the base does not drive backwards";
  return {};
}

}  // namespace

std::unique_ptr<Behavior> make_spin(const SpinGoal& goal, const BehaviorOptions& options, Time accepted) {
  // Nav2 has no INVALID_INPUT for spin.
  if (!std::isfinite(goal.target_yaw))
    return std::make_unique<Refused>(BehaviorError::unknown, "target_yaw is not finite");
  const TravelGoal travel{.axis = TravelAxis::rotation,
                          .target = goal.target_yaw,
                          .top_rate = options.max_rotational_vel,
                          .time_allowance = goal.time_allowance,
                          .is_watched = !goal.disable_collision_checks};
  return std::make_unique<Travel>(travel, options, accepted);
}

std::unique_ptr<Behavior> make_drive_on_heading(const DriveGoal& goal, const BehaviorOptions& options,
                                                const Limits& limits, Time accepted) {
  if (std::string fault = fault_of(goal, limits); !fault.empty())
    return std::make_unique<Refused>(BehaviorError::invalid_input, std::move(fault));
  const TravelGoal travel{.axis = TravelAxis::straight,
                          .target = goal.target.x(),
                          .top_rate = std::abs(goal.speed),
                          .time_allowance = goal.time_allowance,
                          .is_watched = !goal.disable_collision_checks};
  return std::make_unique<Travel>(travel, options, accepted);
}

std::unique_ptr<Behavior> make_back_up(const DriveGoal& goal, const BehaviorOptions& options,
                                       const Limits& limits, Time accepted) {
  DriveGoal backward = goal;
  backward.target.x() = -std::abs(goal.target.x());
  backward.speed = -std::abs(goal.speed);
  return make_drive_on_heading(backward, options, limits, accepted);
}

}  // namespace bw
