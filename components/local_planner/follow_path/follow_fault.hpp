// Why a goal of follow_path ends without the robot being there: Nav2's kinds of failure, and a sentence.
#pragma once

#include <string>

#include "components/model/nav2_error_codes.hpp"

namespace bw {

/// With the values of FollowPath's error_code.
enum class FollowFault : Nav2ErrorCode {
  none = kNoError,
  unknown = follow_path_error::kUnknown,
  invalid_controller = follow_path_error::kInvalidController,
  tf_error = follow_path_error::kTfError,
  invalid_path = follow_path_error::kInvalidPath,
  patience_exceeded = follow_path_error::kPatienceExceeded,
  failed_to_make_progress = follow_path_error::kFailedToMakeProgress,
  no_valid_control = follow_path_error::kNoValidControl,
  controller_timed_out = follow_path_error::kControllerTimedOut,
};

struct FollowFailure {
  FollowFault fault = FollowFault::none;
  std::string reason;
};

}  // namespace bw
