#include "components/emulators/eddie/eddie_drive.hpp"

#include <algorithm>
#include <cmath>

namespace bw::emulators {
namespace {

constexpr double kPowerLag = 0.1;  // [s] of a wheel that a voltage drives
constexpr double kArrived = 0.5;   // [positions]

double ramped(double speed, double target, double most) {
  return speed + std::clamp(target - speed, -most, most);
}

}  // namespace

void EddieDrive::switch_off() {
  waiting_.clear();
  motion_ = {.kind = EddieMotion::Kind::power, .wheels = {}, .distance = 0.0};
}

void EddieDrive::begin(const EddieMotion& motion, const WheelPair& positions) {
  motion_ = motion;
  goal_ = {positions.left + motion.wheels.left, positions.right + motion.wheels.right};
  if (motion.kind != EddieMotion::Kind::stop) return;
  const double fastest = std::max(std::abs(speeds_.left), std::abs(speeds_.right));
  deceleration_ = motion.distance > 0.0 ? fastest * fastest / (2.0 * motion.distance) : 0.0;
  if (motion.distance <= 0.0) speeds_ = {};
}

double EddieDrive::travelling(double speed, double goal, double position, double dt) const {
  const double left = goal - position;
  if (std::abs(left) < kArrived) return 0.0;
  const double allowed = std::min(motion_.distance, std::sqrt(2.0 * acceleration_ * std::abs(left)));
  return ramped(speed, std::copysign(allowed, left), acceleration_ * dt);
}

void EddieDrive::step(Time now, double dt, const WheelPair& positions) {
  while (!waiting_.empty() && now - waiting_.front().at >= latency_) {
    begin(waiting_.front().motion, positions);
    waiting_.pop_front();
  }
  const auto follow = [&](double& speed, double wanted, double goal, double position) {
    switch (motion_.kind) {
      case EddieMotion::Kind::power:
        speed += (wanted - speed) * (1.0 - std::exp(-dt / kPowerLag));
        break;
      case EddieMotion::Kind::speed:
        speed = ramped(speed, wanted, acceleration_ * dt);
        break;
      case EddieMotion::Kind::stop:
        speed = ramped(speed, 0.0, deceleration_ * dt);
        break;
      case EddieMotion::Kind::travel:
        speed = travelling(speed, goal, position, dt);
        break;
    }
  };
  follow(speeds_.left, motion_.wheels.left, goal_.left, positions.left);
  follow(speeds_.right, motion_.wheels.right, goal_.right, positions.right);
}

}  // namespace bw::emulators
