#include "components/emulators/kobuki/kobuki_motors.hpp"

#include <algorithm>
#include <cmath>

namespace bw::emulators {
namespace {

constexpr double kMaxSpeed = 0.7;          // [m/s]
constexpr double kFrictionCurrent = 0.35;  // [A] at top speed
constexpr double kStallCurrent = 4.5;      // [A] when all of the top speed is lacking
constexpr double kMaxCurrent = 3.0;        // [A]
constexpr double kMillimetres = 0.001;

void watch(MotorState& motor, double wanted, double actual, double target) {
  if (motor.is_over && target == 0.0) motor.is_over = false;
  motor.current = motor.is_over ? 0.0 : motor_current(wanted, actual);
  if (motor.current > kMaxCurrent) motor.is_over = true;
}

}  // namespace

WheelSpeeds decode_base_control(int speed, int radius, double wheelbase) {
  const double outer = speed * kMillimetres;
  if (radius == 0) return {outer, outer};
  if (radius == 1) return {-outer, outer};
  const double half = wheelbase / 2.0 / kMillimetres;
  const double r = radius;
  // The centre goes r omega, the wheels (r - half) omega and (r + half) omega.
  return r > 0.0 ? WheelSpeeds{outer * (r - half) / (r + half), outer}
                 : WheelSpeeds{outer, outer * (r + half) / (r - half)};
}

double motor_current(double wanted, double actual) {
  return (kFrictionCurrent * std::abs(actual) + kStallCurrent * std::abs(wanted - actual)) / kMaxSpeed;
}

void KobukiMotors::base_control(Time now, int speed, int radius) {
  WheelSpeeds wheels = decode_base_control(speed, radius, options_.wheelbase);
  const double fastest = std::max(std::abs(wheels.left), std::abs(wheels.right));
  if (fastest > kMaxSpeed) {
    wheels.left *= kMaxSpeed / fastest;
    wheels.right *= kMaxSpeed / fastest;
  }
  controller_.command(now, wheels);
  commanded_ = now;
}

void KobukiMotors::step(Time now, double dt, const WheelSpeeds& actual) {
  const bool is_left_alone = commanded_ && options_.stops_by_itself > 0.0 &&
                             now - *commanded_ > Duration::seconds(options_.stops_by_itself);
  if (is_left_alone) controller_.release();
  controller_.step(now, dt);
  watch(left_, controller_.speeds().left, actual.left, controller_.target().left);
  watch(right_, controller_.speeds().right, actual.right, controller_.target().right);
}

WheelSpeeds KobukiMotors::speeds() const {
  return {left_.is_over ? 0.0 : controller_.speeds().left, right_.is_over ? 0.0 : controller_.speeds().right};
}

}  // namespace bw::emulators
