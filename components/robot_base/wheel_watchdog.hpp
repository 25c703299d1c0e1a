// The last guard before the motors: no fresh wheel command for `timeout` means a ramp to rest, whatever the
// rest of the system does.
//
// In between, what a late command costs is said by its age alone, however late or seldom one looks:
//
//   fastest wheel = commanded - stop_deceleration * max(0, age - timeout), both wheels in proportion
//
// After a stop, commands are reached with at most `acceleration` of the faster wheel: whoever commands knows
// nothing of it.
#pragma once

#include <cstdint>
#include <optional>

#include "components/model/differential_drive.hpp"
#include "runtime/base/field.hpp"
#include "runtime/base/time.hpp"

namespace bw {

struct WatchdogOptions {
  double timeout = 0.2;

  template <class Visitor>
  void fields(Visitor& v) {
    v("timeout", timeout,
      {.unit = "s",
       .min = 0.02,
       .max = 1,
       .doc = "oldest wheel command the base still obeys; every 0.1 s is v * 0.1 m of blind travel"});
  }
};

enum class WatchdogState {
  waiting,   ///< no command yet: the wheels stand
  obeying,   ///< the newest command is fresh
  stopping,  ///< it is not: ramping to rest
  stopped    ///< at rest until a fresh command comes
};

struct WatchdogOutput {
  WheelSpeeds wheels;  ///< for the driver, ground speeds [m/s]
  WatchdogState state = WatchdogState::waiting;
};

/// Times are of the component clock: the moment a command arrived, not its stamp. Call step() every 10 ms.
class WheelWatchdog {
 public:
  /// Both [m/s^2], of the faster wheel.
  WheelWatchdog(const WatchdogOptions& options, double stop_deceleration, double acceleration);

  /// A command that arrived at `now`. One with a value that is not finite is refused (false) and does not
  /// count as fresh.
  bool command(Time now, const WheelSpeeds& wheels);
  /// Drops the newest command: the next step() begins to brake.
  void revoke() { arrival_.reset(); }
  WatchdogOutput step(Time now);
  /// Instead of step(), where something else decides about the wheels; the newest command is dropped.
  void overrule(Time now, const WheelSpeeds& wheels);

  std::uint64_t timeouts() const { return timeouts_; }
  std::uint64_t refused() const { return refused_; }

 private:
  friend struct GuardState;  ///< of tests: what decides what it does next
  WheelSpeeds approached(double dt) const;

  Duration timeout_;
  double stop_deceleration_;
  double acceleration_;
  std::optional<Time> arrival_;
  WheelSpeeds commanded_;
  WheelSpeeds obeyed_;  ///< given out when a command was fresh last
  std::optional<Time> last_step_;
  WatchdogOutput output_;
  bool is_catching_up_ = false;  ///< with commands, after a stop
  std::uint64_t timeouts_ = 0;
  std::uint64_t refused_ = 0;
};

}  // namespace bw
