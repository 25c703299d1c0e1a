#include "components/robot_base/wheel_watchdog.hpp"

#include <cmath>

#include "components/model/stopping.hpp"

namespace bw {

WheelWatchdog::WheelWatchdog(const WatchdogOptions& options, double stop_deceleration)
    : timeout_(Duration::seconds(options.timeout)), stop_deceleration_(stop_deceleration) {}

bool WheelWatchdog::command(Time now, const WheelSpeeds& wheels) {
  if (!std::isfinite(wheels.left) || !std::isfinite(wheels.right)) {
    ++refused_;
    return false;
  }
  arrival_ = now;
  commanded_ = wheels;
  return true;
}

WatchdogOutput WheelWatchdog::step(Time now) {
  const double dt = last_step_ && now > *last_step_ ? (now - *last_step_).to_seconds() : 0.0;
  last_step_ = now;
  if (!arrival_) return output_;
  if (*arrival_ > now)
    arrival_ = now;  // the clock went back: a command must not stay fresh until it is there again
  if (now - *arrival_ < timeout_) {
    output_ = {commanded_, WatchdogState::obeying};
    return output_;
  }
  if (output_.state == WatchdogState::obeying) ++timeouts_;
  output_.wheels = brake(output_.wheels, stop_deceleration_, dt);
  output_.state = output_.wheels == WheelSpeeds{} ? WatchdogState::stopped : WatchdogState::stopping;
  return output_;
}

}  // namespace bw
