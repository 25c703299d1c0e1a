// The four actions: what their goals ask for, what their feedback and results say, in any distribution's
// layout. Pure conversions.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include <builtin_interfaces/msg/duration.hpp>

#include "components/behaviors/behavior_goals.hpp"
#include "components/behaviors/wait.hpp"
#include "components/messages/nav2_goals.hpp"
#include "components/messages/nav2_results.hpp"
#include "components/model/nav2_error_codes.hpp"
#include "runtime/stamps.hpp"

namespace bw {

inline Duration from_message(const builtin_interfaces::msg::Duration& message) {
  return {message.sec() * std::int64_t{1'000'000'000} + message.nanosec()};
}

/// Nav2's numbers for what went wrong in one action; `unknown` where it has none.
struct BehaviorCodes {
  Nav2ErrorCode unknown, timeout, tf_error, collision_ahead, invalid_input;

  Nav2ErrorCode of(BehaviorError error) const {
    switch (error) {
      case BehaviorError::none:
        return kNoError;
      case BehaviorError::timeout:
        return timeout;
      case BehaviorError::tf_error:
        return tf_error;
      case BehaviorError::collision_ahead:
        return collision_ahead;
      case BehaviorError::invalid_input:
        return invalid_input;
      case BehaviorError::unknown:
        break;
    }
    return unknown;
  }
};

struct SpinMessages {
  static constexpr BehaviorCodes kCodes{spin_error::kUnknown, spin_error::kTimeout, spin_error::kTfError,
                                        spin_error::kCollisionAhead, spin_error::kUnknown};
  static std::unique_ptr<Behavior> behavior(const auto& goal, const BehaviorOptions& options, const Limits&,
                                            Time now) {
    return make_spin({.target_yaw = goal.target_yaw(),
                      .time_allowance = from_message(goal.time_allowance()),
                      .disable_collision_checks = disables_collision_checks(goal)},
                     options, now);
  }
  static void write(auto& feedback, const BehaviorStep& step) {
    feedback.angular_distance_traveled(static_cast<float>(step.traveled));
  }
};

DriveGoal to_drive_goal(const auto& goal) {
  return {.target = {goal.target().x(), goal.target().y()},
          .target_z = goal.target().z(),
          .speed = goal.speed(),
          .time_allowance = from_message(goal.time_allowance()),
          .disable_collision_checks = disables_collision_checks(goal)};
}

struct DriveOnHeadingMessages {
  static constexpr BehaviorCodes kCodes{
      drive_on_heading_error::kUnknown, drive_on_heading_error::kTimeout, drive_on_heading_error::kTfError,
      drive_on_heading_error::kCollisionAhead, drive_on_heading_error::kInvalidInput};
  static std::unique_ptr<Behavior> behavior(const auto& goal, const BehaviorOptions& options,
                                            const Limits& limits, Time now) {
    return make_drive_on_heading(to_drive_goal(goal), options, limits, now);
  }
  static void write(auto& feedback, const BehaviorStep& step) {
    feedback.distance_traveled(static_cast<float>(step.traveled));
  }
};

struct BackUpMessages : DriveOnHeadingMessages {
  static constexpr BehaviorCodes kCodes{back_up_error::kUnknown, back_up_error::kTimeout,
                                        back_up_error::kTfError, back_up_error::kCollisionAhead,
                                        back_up_error::kInvalidInput};
  static std::unique_ptr<Behavior> behavior(const auto& goal, const BehaviorOptions& options,
                                            const Limits& limits, Time now) {
    return make_back_up(to_drive_goal(goal), options, limits, now);
  }
};

struct WaitMessages {
  static constexpr BehaviorCodes kCodes{wait_error::kUnknown, wait_error::kTimeout, wait_error::kUnknown,
                                        wait_error::kUnknown, wait_error::kUnknown};
  static std::unique_ptr<Behavior> behavior(const auto& goal, const BehaviorOptions&, const Limits&,
                                            Time now) {
    return std::make_unique<Wait>(from_message(goal.time()), now);
  }
  static void write(auto& feedback, const BehaviorStep& step) { feedback.time_left(to_message(step.left)); }
};

}  // namespace bw
