// Why a goal of follow_path ends without the robot being there: Nav2's kinds of failure, and a sentence.
#pragma once

#include <cstdint>
#include <string>

namespace bw {

/// With the numbers of FollowPath's error_code, from Jazzy on.
enum class FollowFault : std::uint16_t {
  none = 0,
  unknown = 100,
  invalid_controller = 101,
  tf_error = 102,
  invalid_path = 103,
  patience_exceeded = 104,
  failed_to_make_progress = 105,
  no_valid_control = 106,
  controller_timed_out = 107,
};

struct FollowFailure {
  FollowFault fault = FollowFault::none;
  std::string reason;
};

}  // namespace bw
