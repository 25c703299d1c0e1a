// Whether the navigator has a goal in hand, and when somebody gives another one, by navigation_status.
#pragma once

#include <cstdint>

#include "runtime/base/goal_status.hpp"

namespace bw {

class GoalInHand {
 public:
  /// A report on a goal, and how many of its list follow it. True: what was in hand is over, and nothing goes
  /// on by itself: it ended, or somebody gave another goal. What only follows in a list goes on.
  bool see(std::uint64_t id, GoalStatus status, std::uint32_t remaining) {
    bool is_given = false;
    if (id != id_) {
      if (is_final(status)) return false;  // refused, or preempted by the one in hand
      is_given = status == GoalStatus::accepted && !is_between_;
      id_ = id;
    }
    is_between_ = is_final(status) && remaining > 0;
    is_in_hand_ = !is_final(status) || is_between_;
    return is_given || !is_in_hand_;
  }
  bool is_in_hand() const { return is_in_hand_; }

 private:
  std::uint64_t id_ = 0;  ///< of the goal in hand, or of the last one
  bool is_in_hand_ = false;
  bool is_between_ = false;  ///< two goals of a list
};

}  // namespace bw
