#include "components/robot_base/calibration/leg_driver.hpp"

#include <algorithm>
#include <cmath>

namespace bw {
namespace {

constexpr double kStillV = 0.01;      // [m/s]
constexpr double kStillOmega = 0.02;  // [rad/s]

/// So fast that it comes to rest after `rest` more, and fast enough to get there.
double speed_towards(double rest, double most, double deceleration) {
  return std::clamp(std::sqrt(2.0 * deceleration * std::max(rest, 0.0)), 0.1 * most, most);
}

}  // namespace

LegDriver::LegDriver(const Leg& leg, const LegOptions& options, const Pose2& start)
    : leg_(leg), options_(options), start_(start), heading_(start.theta) {}

double LegDriver::longest() const {
  return 5.0 + 3.0 * (std::abs(leg_.distance) / options_.v + std::abs(leg_.rotation) / options_.omega);
}

std::optional<Twist2> LegDriver::step(const Pose2& X_OB, const Twist2& measured) {
  rotated_ += wrap_angle(X_OB.theta - heading_);
  heading_ = X_OB.theta;
  const Twist2 wish = leg_.rotation != 0.0 ? rotate() : straight(X_OB);
  if (!is_over_) return wish;
  const bool stands = std::abs(measured.v) < kStillV && std::abs(measured.omega) < kStillOmega;
  return stands ? std::nullopt : std::optional(Twist2{});
}

Twist2 LegDriver::straight(const Pose2& X_OB) {
  constexpr double kAside = 1.0;     // [rad/m] back to the line
  constexpr double kAngle = 1.5;     // [1/s]
  constexpr double kSteepest = 0.2;  // [rad]
  const Pose2 at = inverse(start_) * X_OB;
  const double rest = leg_.distance - at.x;
  is_over_ = is_over_ || rest < 0.005;
  if (is_over_) return {};
  const double wanted = std::clamp(-kAside * at.y, -kSteepest, kSteepest);
  const double omega = kAngle * wrap_angle(wanted - at.theta);
  return {speed_towards(rest, options_.v, options_.deceleration),
          std::clamp(omega, -options_.omega / 2.0, options_.omega / 2.0)};
}

Twist2 LegDriver::rotate() {
  const double rest = leg_.rotation - rotated_;
  is_over_ = is_over_ || rest * leg_.rotation <= 0.0 || std::abs(rest) < 0.005;
  if (is_over_) return {};
  return {0.0,
          std::copysign(speed_towards(std::abs(rest), options_.omega, options_.angular_deceleration), rest)};
}

}  // namespace bw
