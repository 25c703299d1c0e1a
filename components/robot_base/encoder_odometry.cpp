#include "components/robot_base/encoder_odometry.hpp"

#include <algorithm>
#include <cmath>

#include "components/model/arc.hpp"
#include "components/model/wheel_step.hpp"
#include "components/robot_base/wrapping_counts.hpp"

namespace bw {

EncoderOdometry::EncoderOdometry(const Robot& robot, const OdometryOptions& options)
    : options_(options),
      separation_(robot.wheel_separation),
      radii_(robot.wheel_radii()),
      metres_per_tick_(robot.metres_per_tick(robot.wheel_radius)),
      left_metres_per_tick_(robot.metres_per_tick(radii_.left)),
      right_metres_per_tick_(robot.metres_per_tick(radii_.right)),
      wheel_speed_max_(std::max(robot.limits.v_max, robot.limits.v_back_max) +
                       robot.limits.omega_max * robot.wheel_separation / 2.0) {}

CountsStatus EncoderOdometry::add(Time now, const EncoderCounts& counts) {
  if (!reference_) {
    reference_ = counts;
    state_.time = counts.time;
    restart_history(counts.time);
    return CountsStatus::first;
  }
  const Time newest = suspect_ ? suspect_->time : reference_->time;
  if (counts.time <= newest) {
    if (newest <= now) {
      ++faults_.stale;
      return CountsStatus::stale;
    }
    restart_history(counts.time);
    reference_ = counts;
    suspect_.reset();
    state_.time = counts.time;
    return CountsStatus::rebased;
  }
  const EncoderCounts* from = &*reference_;
  CountsStatus status = CountsStatus::moved;
  if (!possible(*reference_, counts)) {
    if (!suspect_ || !possible(*suspect_, counts)) {
      const EncoderCounts power_up{reference_->time, 0, 0};
      const bool reset = possible(power_up, counts);
      ++(reset ? faults_.resets : faults_.jumps);
      suspect_ = counts;
      return reset ? CountsStatus::reset : CountsStatus::jump;
    }
    from = &*suspect_;
    status = CountsStatus::rebased;
  }
  const double ds_left =
      static_cast<double>(wrapping_difference(from->left, counts.left)) * left_metres_per_tick_;
  const double ds_right =
      static_cast<double>(wrapping_difference(from->right, counts.right)) * right_metres_per_tick_;
  if (status == CountsStatus::rebased) restart_history(from->time);
  travel_ = {(counts.time - from->time).to_seconds(), ds_left, ds_right};
  reference_ = counts;
  suspect_.reset();
  state_.time = counts.time;
  integrate(ds_left, ds_right);
  measure_twist();
  return status;
}

bool EncoderOdometry::possible(const EncoderCounts& from, const EncoderCounts& to) const {
  constexpr double kRoundingTicks = 2.0;
  const double seconds = (to.time - from.time).to_seconds();
  const double reach = options_.speed_margin * wheel_speed_max_ * seconds / metres_per_tick_ + kRoundingTicks;
  return wrapping_distance(from.left, to.left) <= reach && wrapping_distance(from.right, to.right) <= reach;
}

void EncoderOdometry::restart_history(Time time) {
  const Travelled last = history_size_ > 0 ? history_[history_size_ - 1] : Travelled{};
  history_[0] = {time, last.distance, last.rotation};
  history_size_ = 1;
}

void EncoderOdometry::integrate(double ds_left, double ds_right) {
  const WheelStep step =
      step_from_wheels(state_.time, {}, ds_left, ds_right, separation_, options_.variance_per_metre);
  state_.pose_covariance = covariance_after(state_.X_OB, state_.pose_covariance, step);
  state_.X_OB = advance_arc(state_.X_OB, step.distance, step.rotation);
  state_.left_angle += ds_left / radii_.left;
  state_.right_angle += ds_right / radii_.right;

  if (history_size_ == kHistory) {
    std::copy(history_ + 1, history_ + kHistory, history_);
    --history_size_;
  }
  const Travelled& last = history_[history_size_ - 1];
  history_[history_size_++] = {state_.time, last.distance + step.distance, last.rotation + step.rotation};
}

void EncoderOdometry::measure_twist() {
  const Travelled& now = history_[history_size_ - 1];
  const Duration window = Duration::seconds(options_.velocity_window);
  int oldest = history_size_ - 2;
  while (oldest > 0 && now.time - history_[oldest - 1].time <= window) --oldest;
  const Travelled& then = history_[oldest];
  const double seconds = (now.time - then.time).to_seconds();
  state_.twist = {(now.distance - then.distance) / seconds, (now.rotation - then.rotation) / seconds};

  // Each wheel's travel over the window is known to a rounding at both ends (tick^2 / 12 each) and to its
  // slip.
  const double slip = options_.variance_per_metre * std::abs(now.distance - then.distance);
  const double wheel_variance = (slip + metres_per_tick_ * metres_per_tick_ / 6.0) / (seconds * seconds);
  state_.twist_covariance(0, 0) = wheel_variance / 2.0;
  state_.twist_covariance(1, 1) = 2.0 * wheel_variance / (separation_ * separation_);
}

}  // namespace bw
