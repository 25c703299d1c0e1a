#include "components/robot_base/wheel_watchdog.hpp"

#include <algorithm>
#include <cmath>

#include "components/model/stopping.hpp"

namespace bw {
namespace {

double fastest(const WheelSpeeds& wheels) { return std::max(std::abs(wheels.left), std::abs(wheels.right)); }

}  // namespace

WheelWatchdog::WheelWatchdog(const WatchdogOptions& options, double stop_deceleration, double acceleration)
    : timeout_(Duration::seconds(options.timeout)),
      stop_deceleration_(stop_deceleration),
      acceleration_(acceleration) {}

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
  if (!arrival_ && output_.state == WatchdogState::waiting) return output_;
  if (arrival_ && *arrival_ > now) revoke();  // the clock went back: nobody knows how old it is
  if (arrival_ && now - *arrival_ < timeout_) {
    output_ = {approached(dt), WatchdogState::obeying};
    is_catching_up_ = is_catching_up_ && output_.wheels != commanded_;
    obeyed_ = output_.wheels;
    return output_;
  }
  if (output_.state == WatchdogState::obeying) ++timeouts_;
  is_catching_up_ = true;
  output_.wheels = arrival_ ? brake(obeyed_, stop_deceleration_, (now - *arrival_ - timeout_).to_seconds())
                            : brake(output_.wheels, stop_deceleration_, dt);
  output_.state = output_.wheels == WheelSpeeds{} ? WatchdogState::stopped : WatchdogState::stopping;
  return output_;
}

void WheelWatchdog::overrule(Time now, const WheelSpeeds& wheels) {
  revoke();
  last_step_ = now;
  is_catching_up_ = true;
  if (output_.state == WatchdogState::waiting && wheels == WheelSpeeds{}) return;
  output_ = {wheels, wheels == WheelSpeeds{} ? WatchdogState::stopped : WatchdogState::stopping};
}

WheelSpeeds WheelWatchdog::approached(double dt) const {
  if (!is_catching_up_) return commanded_;
  const double allowed = fastest(output_.wheels) + acceleration_ * dt;
  const double wished = fastest(commanded_);
  if (wished <= allowed) return commanded_;
  return {commanded_.left * (allowed / wished), commanded_.right * (allowed / wished)};
}

}  // namespace bw
