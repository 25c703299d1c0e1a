#include "components/emulators/wheel_controller.hpp"

#include <algorithm>
#include <cmath>

namespace bw::emulators {

double WheelController::followed(double speed, double target, double dt) const {
  const double share = options_.lag > 0.0 ? 1.0 - std::exp(-dt / options_.lag) : 1.0;
  const double most = options_.acceleration * dt;
  return speed + std::clamp((target - speed) * share, -most, most);
}

void WheelController::step(Time now, double dt) {
  while (!waiting_.empty() && now - waiting_.front().at >= Duration::seconds(options_.latency)) {
    target_ = waiting_.front().wheels;
    waiting_.pop_front();
  }
  speeds_.left = followed(speeds_.left, target_.left, dt);
  speeds_.right = followed(speeds_.right, target_.right, dt);
}

}  // namespace bw::emulators
