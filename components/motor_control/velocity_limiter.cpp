#include "components/motor_control/velocity_limiter.hpp"

#include <algorithm>
#include <cmath>

#include "components/model/stopping.hpp"

namespace bw {
std::string_view describe(LimiterState state) {
  switch (state) {
    case LimiterState::waiting:
      return "no velocity command yet";
    case LimiterState::following:
      return "following the velocity command";
    case LimiterState::stale:
      return "velocity commands stopped coming";
    case LimiterState::not_finite:
      return "the velocity command is not a finite number";
    case LimiterState::implausible:
      return "the velocity command is far beyond the limits of the robot";
    case LimiterState::told_to:
      return "told to stop";
  }
  return "unknown";
}

Twist2 saturate(const Twist2& twist, const Limits& limits, double wheel_separation, double wheel_speed_max) {
  const double v_limit = twist.v >= 0.0 ? limits.v_max : limits.v_back_max;
  const double fastest_wheel = std::abs(twist.v) + std::abs(twist.omega) * wheel_separation / 2.0;
  double scale = 1.0;
  if (std::abs(twist.v) > v_limit) scale = std::min(scale, v_limit / std::abs(twist.v));
  if (std::abs(twist.omega) > limits.omega_max)
    scale = std::min(scale, limits.omega_max / std::abs(twist.omega));
  if (fastest_wheel > wheel_speed_max) scale = std::min(scale, wheel_speed_max / fastest_wheel);
  return {twist.v * scale, twist.omega * scale};
}

VelocityLimiter::VelocityLimiter(const Robot& robot, const LimiterOptions& options)
    : limits_(robot.limits),
      allowed_(robot.limits),
      half_separation_(robot.wheel_separation / 2.0),
      wheel_speed_max_(robot.wheel_speed_max),
      timeout_(Duration::seconds(options.command_timeout)),
      plausible_factor_(options.plausible_factor) {}

void VelocityLimiter::command(Time now, const Twist2& twist) {
  arrival_ = now;
  command_ = twist;
}

LimitedTwist VelocityLimiter::step(Time now) {
  const double dt = elapsed(now);
  const LimiterState state = judge(now);
  if (state == LimiterState::following) {
    const Twist2 wish = saturate(command_, allowed_, 2.0 * half_separation_, wheel_speed_max_);
    follow(wish, dt);
  } else {
    brake_to_rest(dt);
  }
  return {twist_, state};
}

LimitedTwist VelocityLimiter::stop(Time now) {
  brake_to_rest(elapsed(now));
  return {twist_, LimiterState::told_to};
}

void VelocityLimiter::rest() {
  arrival_.reset();
  last_step_.reset();
  twist_ = {};
  acceleration_ = 0.0;
}

/// After a stall a command catches up no more than the longest step; before that the base has braked, which
/// knows of no stall.
double VelocityLimiter::elapsed(Time now) {
  constexpr double kLongestStep = 0.1;  // [s]
  const double dt = last_step_ ? std::max(0.0, (now - *last_step_).to_seconds()) : 0.0;
  last_step_ = now;
  if (arrival_ && *arrival_ > now) arrival_.reset();  // the clock went back: how old it is nobody knows
  if (dt > kLongestStep) brake_to_rest(dt - kLongestStep);
  return std::min(dt, kLongestStep);
}

LimiterState VelocityLimiter::judge(Time now) const {
  if (!arrival_) return LimiterState::waiting;
  if (!is_finite(command_)) return LimiterState::not_finite;
  const double v_scale = std::max(limits_.v_max, limits_.v_back_max);
  if (std::abs(command_.v) > plausible_factor_ * v_scale ||
      std::abs(command_.omega) > plausible_factor_ * limits_.omega_max) {
    return LimiterState::implausible;
  }
  return now - *arrival_ > timeout_ ? LimiterState::stale : LimiterState::following;
}

void VelocityLimiter::follow(const Twist2& wish, double dt) {
  if (dt <= 0.0) return;
  const Twist2 braking = braking_ == Braking::hard ? braking_towards(wish, twist_, limits_.stop_deceleration,
                                                                     2.0 * half_separation_)
                                                   : Twist2{};
  braking.v > 0.0 ? brake_towards(wish.v, braking.v * dt) : approach(wish.v, dt);

  // The speed may still rise to v + a |a| / (2 j); leave the wheels room for it.
  const double rise = acceleration_ * std::abs(acceleration_) / (2.0 * limits_.jerk_max);
  const double v_peak = std::max(std::abs(twist_.v), std::abs(twist_.v + rise));
  const double omega_left = std::max(0.0, wheel_speed_max_ - v_peak) / half_separation_;
  const double step = (braking.omega > 0.0 ? braking.omega : limits_.alpha_max) * dt;
  const double omega = twist_.omega + std::clamp(wish.omega - twist_.omega, -step, step);
  twist_.omega = std::clamp(omega, -omega_left, omega_left);
}

void VelocityLimiter::approach(double wish, double dt) {
  const double jerk = limits_.jerk_max;
  const double v_left = std::max(0.0, wheel_speed_max_ - std::abs(twist_.omega) * half_separation_);
  const double error = std::clamp(wish, -v_left, v_left) - twist_.v;
  double a = 2.0 * error / (dt + std::sqrt(dt * dt + 2.0 * std::abs(error) / jerk));
  a = std::clamp(a, -limits_.acc_max, limits_.acc_max);
  a = std::clamp(a, acceleration_ - jerk * dt, acceleration_ + jerk * dt);
  twist_.v += a * dt;
  acceleration_ = a;
}

void VelocityLimiter::brake_towards(double wish, double loss) {
  const double target = wish * twist_.v > 0.0 ? std::abs(wish) : 0.0;
  twist_.v = std::copysign(std::max(target, std::abs(twist_.v) - loss), twist_.v);
  acceleration_ = 0.0;
}

void VelocityLimiter::brake_to_rest(double dt) {
  const WheelSpeeds wheels = to_wheel_speeds(twist_, 2.0 * half_separation_);
  twist_ = to_twist(brake(wheels, limits_.stop_deceleration, dt), 2.0 * half_separation_);
  acceleration_ = 0.0;
}

}  // namespace bw
