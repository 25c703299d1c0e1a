// Strictly one request, one reply: what an Eddie's board wants. Nothing is sent before the reply to what was
// sent is there, or its time is over. What is late, or was not asked for, must not be taken for the next
// reply: after a time-out, an unexpected line or half a one, what comes is thrown away until the line was
// quiet for a while.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "runtime/base/byte_link.hpp"
#include "runtime/base/time.hpp"

namespace bw::eddie {

enum class Request {
  stop,
  reason,
  verbose,
  version,
  hardware,
  watch,
  acceleration,
  sonars,
  drive,
  counts,
  analog,
  sonar
};

struct Reply {
  Request request = Request::stop;
  bool is_timeout = false;
  std::string text;  ///< the line without its end
  Time sent, arrived;
};

struct DialogueCounts {
  std::uint64_t replies = 0, timeouts = 0;
  std::uint64_t unexpected_lines = 0;  ///< nobody asked for them
  std::uint64_t bytes_thrown_away =
      0;  ///< of lines that were too long or not text, half lines, and what came too late
};

class Dialogue {
 public:
  explicit Dialogue(Duration timeout) : timeout_(timeout) {}

  /// Forgets what is open and listens for `quiet` before the next request.
  void begin(Time now, Duration quiet);
  /// What was read; at most one reply comes of it, or the time-out of what was asked.
  std::optional<Reply> take(Time now, std::span<const std::uint8_t> bytes);
  /// The reply that take() gave was not one to its request.
  void refuse(Time now);
  bool is_free(Time now) const { return !asked_ && now >= quiet_until_; }
  /// False when the bytes were not taken; nothing is asked then. Only when is_free().
  bool ask(Time now, Request request, std::string_view text, ByteLink& link);

  const DialogueCounts& counts() const { return counts_; }

 private:
  struct Asked {
    Request request;
    Time at;
  };
  void throw_away();
  bool take_byte(std::uint8_t byte);

  Duration timeout_;
  std::optional<Asked> asked_;
  Time quiet_until_;
  std::string line_;  ///< so far
  bool is_broken_ = false;
  DialogueCounts counts_;
};

}  // namespace bw::eddie
