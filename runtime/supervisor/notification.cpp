#include "runtime/supervisor/notification.hpp"

#include <algorithm>

namespace bw {

Notification parse_notification(std::string_view text) {
  Notification said;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    constexpr std::string_view kStatus = "STATUS=";
    said.is_ready |= line == "READY=1";
    said.is_alive |= line == "WATCHDOG=1";
    said.hangs |= line == "WATCHDOG=trigger";
    said.is_stopping |= line == "STOPPING=1";
    said.is_over |= line == "X_BANDWAGON_OVER=1";
    if (line.starts_with(kStatus)) said.status = line.substr(kStatus.size());
  }
  return said;
}

}  // namespace bw
