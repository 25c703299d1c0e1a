#include "runtime/supervisor/notification.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace bw {

namespace {

/// Of microseconds, ten minutes at most; nothing: it is no number.
std::optional<Duration> extension(std::string_view text) {
  constexpr std::int64_t kMax = 600'000'000;
  std::int64_t microseconds = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), microseconds);
  if (error != std::errc{} || end != text.data() + text.size() || microseconds < 0) return std::nullopt;
  return Duration{std::min(microseconds, kMax) * 1000};
}

}  // namespace

Notification parse_notification(std::string_view text) {
  Notification said;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    constexpr std::string_view kStatus = "STATUS=";
    constexpr std::string_view kExtend = "EXTEND_TIMEOUT_USEC=";
    said.is_ready |= line == "READY=1";
    said.is_alive |= line == "WATCHDOG=1";
    said.hangs |= line == "WATCHDOG=trigger";
    said.is_stopping |= line == "STOPPING=1";
    said.is_over |= line == "X_BANDWAGON_OVER=1";
    if (line.starts_with(kExtend)) said.extended = extension(line.substr(kExtend.size()));
    if (line.starts_with(kStatus)) said.status = line.substr(kStatus.size());
  }
  return said;
}

}  // namespace bw
