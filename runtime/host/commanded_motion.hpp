// When something was last told to move, by the bytes of the commands that a process sends and obeys. The
// runtime knows no robot: a command by which nothing moves is one whose floating-point numbers are all zero,
// a Twist or the rates of wheels at rest.
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <map>
#include <mutex>
#include <span>
#include <string_view>

#include "runtime/base/time.hpp"
#include "runtime/ports.hpp"
#include "runtime/wire/type_description.hpp"

namespace bw {

/// From any thread.
class CommandedMotion {
 public:
  /// What this program has no description of may be a motion.
  void see(const MessageType& type, std::span<const std::uint8_t> cdr, Duration now);
  /// Nothing was told to move within this time before `now`; both are of the steady clock.
  bool is_over_since(Duration time, Duration now) const { return now - Duration{last_ns_} >= time; }

 private:
  const TypeDescription* description_of(const MessageType& type);

  std::atomic<std::int64_t> last_ns_ = std::numeric_limits<std::int64_t>::min() / 2;
  std::mutex mutex_;
  std::map<std::string_view, const TypeDescription*> types_;  ///< by hash
};

}  // namespace bw
