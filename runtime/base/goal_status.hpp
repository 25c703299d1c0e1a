// The states of a goal, as action_msgs/msg/GoalStatus has them.
#pragma once

#include <cstdint>

namespace bw {

enum class GoalStatus : std::uint8_t {
  unknown = 0,
  accepted = 1,
  executing = 2,
  canceling = 3,
  succeeded = 4,
  canceled = 5,
  aborted = 6
};

constexpr bool is_final(GoalStatus status) { return status >= GoalStatus::succeeded; }

}  // namespace bw
