// The odometry of a log as a base would publish it: with twist and covariance.
#pragma once

#include "components/model/odometry_state.hpp"
#include "components/recordings/recorded_drive.hpp"

namespace bw {

class PlayedOdometry {
 public:
  /// Of a drive that outlives it, played `rate` times as fast as it was.
  PlayedOdometry(const RecordedDrive& drive, double variance_per_metre, double rate)
      : drive_(drive), variance_per_metre_(variance_per_metre), rate_(rate) {}

  /// The next sample, which outlives this, published at `time`.
  OdometryState next(const OdometrySample& sample, Time time) {
    OdometryState state;
    state.time = time;
    state.X_OB = sample.X_OB;
    state.twist = {sample.twist.v * rate_, sample.twist.omega * rate_};
    if (before_ != nullptr) {
      const WheelStep step = step_between(drive_, *before_, sample, variance_per_metre_);
      covariance_ = covariance_after(before_->X_OB, covariance_, step);
      const double seconds = step.over.to_seconds() / rate_;
      state.twist_covariance = step.covariance / (seconds * seconds);
    }
    state.pose_covariance = covariance_;
    before_ = &sample;
    return state;
  }

 private:
  const RecordedDrive& drive_;
  double variance_per_metre_;
  double rate_;
  const OdometrySample* before_ = nullptr;
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
};

}  // namespace bw
