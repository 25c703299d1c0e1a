// A row of the failsafe table: what is watched, what the robot does about it, and how it drives again. Components declare
// theirs; `bandwagon failsafes GRAPH` prints those of a graph, /diagnostics tells which are in force.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "runtime/base/time.hpp"

namespace bw {

enum class FailsafeAction : std::uint8_t {
  warn,
  slow,
  stop,          ///< drives on by itself as `recovery` says
  stop_latched,  ///< until release_stop
};

struct FailsafeRow {
  std::string name;       ///< one word, such as laser_silent: that of the diagnostics
  std::string condition;  ///< for people
  Duration debounce;      ///< so long it has to hold
  FailsafeAction action = FailsafeAction::stop;
  std::string recovery;  ///< for people
};

/// A handle; says whether the row is in force.
class Failsafe {
 public:
  Failsafe() = default;
  explicit Failsafe(std::atomic<bool>* in_force) : in_force_(in_force) {}
  void set(bool in_force) const {
    if (in_force_ != nullptr) *in_force_ = in_force;
  }

 private:
  std::atomic<bool>* in_force_ = nullptr;
};

constexpr const char* text_of(FailsafeAction action) {
  switch (action) {
    case FailsafeAction::warn:
      return "warn";
    case FailsafeAction::slow:
      return "slow";
    case FailsafeAction::stop:
      return "stop";
    case FailsafeAction::stop_latched:
      return "stop, latched";
  }
  return "";
}

}  // namespace bw
