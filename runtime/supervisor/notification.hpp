// What a process says of itself by sd_notify's protocol: lines NAME=VALUE, of which unknown ones mean nothing.
// Source: man sd_notify(3).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "runtime/base/time.hpp"

namespace bw {

struct Notification {
  bool is_ready = false;
  bool is_alive = false;  ///< WATCHDOG=1
  bool hangs = false;     ///< WATCHDOG=trigger
  bool is_stopping = false;
  bool is_over = false;  ///< with STOPPING=1: what it ran is over, it is not to be started again
  std::optional<std::string> status;
  std::optional<Duration> extended;  ///< EXTEND_TIMEOUT_USEC: from now on it takes so long to end
};

Notification parse_notification(std::string_view text);

}  // namespace bw
