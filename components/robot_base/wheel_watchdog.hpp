// The last guard before the motors: no fresh wheel command for `timeout` means a ramp to rest, whatever the
// rest of the system does.
#pragma once

#include <cstdint>
#include <optional>

#include "components/model/differential_drive.hpp"
#include "runtime/base/field.hpp"
#include "runtime/base/time.hpp"

namespace bw {

struct WatchdogOptions {
  double timeout = 0.25;

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
  /// `stop_deceleration` [m/s^2] of the faster wheel.
  WheelWatchdog(const WatchdogOptions& options, double stop_deceleration);

  /// A command that arrived at `now`. One with a value that is not finite is refused (false) and does not
  /// count as fresh.
  bool command(Time now, const WheelSpeeds& wheels);
  /// Makes the newest command stale at once.
  void revoke(Time now) { arrival_ = arrival_ ? std::optional(now - timeout_) : std::nullopt; }
  WatchdogOutput step(Time now);

  std::uint64_t timeouts() const { return timeouts_; }
  std::uint64_t refused() const { return refused_; }

 private:
  Duration timeout_;
  double stop_deceleration_;
  std::optional<Time> arrival_;
  WheelSpeeds commanded_;
  std::optional<Time> last_step_;
  WatchdogOutput output_;
  std::uint64_t timeouts_ = 0;
  std::uint64_t refused_ = 0;
};

}  // namespace bw
