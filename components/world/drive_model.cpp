#include "components/world/drive_model.hpp"

#include <algorithm>
#include <cmath>

#include "components/world/wall_gap.hpp"

namespace bw {
namespace {

double approach(double value, double target, double most) {
  return value + std::clamp(target - value, -most, most);
}

}  // namespace

DriveModel::DriveModel(const DriveOptions& options, const Robot& robot, const Pose2& start, Random random)
    : options_(options), robot_(robot), footprint_(robot.outline()), pose_(start), random_(random) {
  robot_.wheel_separation *= 1.0 + options.separation_error;
}

bool DriveModel::command(const WheelCommand& command) {
  const bool usable = std::isfinite(command.left) && std::isfinite(command.right);
  const auto rim_speed = [&](double rate, double radius) {
    return std::clamp(rate, -options_.kWheelSpeedMax, options_.kWheelSpeedMax) * radius;
  };
  const WheelRadii radii = robot_.wheel_radii();
  target_ = usable ? WheelSpeeds{rim_speed(command.left, radii.left), rim_speed(command.right, radii.right)}
                   : WheelSpeeds{};
  return usable;
}

bool DriveModel::step(double dt, const StaticScene& scene) {
  const WheelSpeeds before = rim_;
  rim_.left = approach(rim_.left, target_.left, options_.wheel_acceleration * dt);
  rim_.right = approach(rim_.right, target_.right, options_.wheel_acceleration * dt);
  WheelSpeeds mean{(before.left + rim_.left) / 2.0, (before.right + rim_.right) / 2.0};

  const double grip = 1.0 - options_.slip;
  const auto moved_by = [&](const WheelSpeeds& rim) {
    const Twist2 twist = to_twist(rim, robot_.wheel_separation);
    return advance_exact(pose_, {twist.v * grip, twist.omega * grip}, dt);
  };
  const auto without_translation = [&](const WheelSpeeds& rim) {
    return to_wheel_speeds({0.0, to_twist(rim, robot_.wheel_separation).omega}, robot_.wheel_separation);
  };
  Pose2 next = moved_by(mean);
  const auto goes_deeper = [&](const Pose2& to) {
    const double gap = wall_gap(scene, footprint_, to, 0.0);
    return gap < 0.0 && gap < wall_gap(scene, footprint_, pose_, 0.0);
  };
  const bool blocked = goes_deeper(next);
  if (blocked) {
    rim_ = without_translation(rim_);
    mean = without_translation(mean);
    next = moved_by(mean);
  }
  if (blocked && footprint_.is_polygon() && goes_deeper(next)) {
    rim_ = mean = {};
    next = pose_;
  }
  pose_ = next;

  const auto measured = [&](double travel, double side) {
    const double noise = random_.normal(0.0, std::sqrt(options_.noise * std::abs(travel)));
    return travel * (1.0 + options_.scale + side * options_.mismatch / 2.0) + noise;
  };
  measured_left_ += measured(mean.left * dt, -1.0);
  measured_right_ += measured(mean.right * dt, +1.0);
  return blocked;
}

Twist2 DriveModel::twist() const {
  const Twist2 rim = to_twist(rim_, robot_.wheel_separation);
  return {rim.v * (1.0 - options_.slip), rim.omega * (1.0 - options_.slip)};
}

EncoderTicks DriveModel::ticks() const {
  const auto counter = [&](double travel, double radius) {
    const std::int64_t count =
        options_.first_tick + static_cast<std::int64_t>(std::floor(travel / robot_.metres_per_tick(radius)));
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(count));
  };
  const WheelRadii radii = robot_.wheel_radii();
  return {counter(measured_left_, radii.left), counter(measured_right_, radii.right)};
}

}  // namespace bw
