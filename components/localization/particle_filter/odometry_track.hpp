// The path by wheels and gyro: where the base was in an odometry frame O during the last seconds, and how far
// the particles are behind. Late measurements need the first, sampling the second.
//
// The gyro, where it covers a step, gives the step's rotation; its bias is learnt while the wheels stand.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "components/localization/measurements.hpp"
#include "components/localization/particle_filter/particle_filter_options.hpp"

namespace bw::localization {

/// A motion in the frame of B before it, with the covariance of (x, y, theta).
struct UncertainMotion {
  Pose2 X_BB;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double distance = 0.0;  ///< [m], forward and backward both counted
  double rotation = 0.0;  ///< [rad], either way
};

class OdometryTrack {
 public:
  OdometryTrack(const ParticleMotionOptions& options, Duration window);

  void restart(Time time);

  /// False when the step ends before newest(): nothing is done. One that began before newest() or after it is
  /// taken as the part or multiple that fits, a longer gap is unknown motion.
  bool add(const WheelStep& step);
  void add(const GyroReading& reading);
  /// Wheels silent for longer than options.extrapolation before `time`: unknown motion up to there.
  void bridge_silence(Time time);

  /// Motion that nobody measured for so long.
  void miss(Duration duration) { advance_unknown(newest_.time + duration); }

  /// X_OB at a time of the window, or extrapolated with the last twist.
  Pose2 at(Time time) const;
  Time newest() const { return newest_.time; }
  /// No pose before; kept for the window.
  Time oldest() const;
  Time last_wheel() const { return last_wheel_; }
  const Twist2& twist() const { return twist_; }
  double odometer() const { return odometer_; }
  double gyro_bias() const { return gyro_bias_; }

  /// What the particles have not followed yet, including alpha1 to alpha4.
  UncertainMotion behind() const;
  /// The particles have followed.
  void follow();

 private:
  struct TimedPose {
    Time time;
    Pose2 X_OB;
  };
  struct Gyro {
    Time last;
    bool seen = false;
    double rate = 0.0;
    double variance = 0.0;
    double angle = 0.0;
    double angle_variance = 0.0;
    double covered = 0.0;  ///< [s]
  };

  void advance_unknown(Time time);
  void push(Time time, const Pose2& X_OB);
  const TimedPose& pose(std::size_t i) const { return poses_[(first_ + i) % poses_.size()]; }
  void hold_gyro(Time time);
  void use_gyro(double dt, double& rotation, Eigen::Matrix2d& covariance, bool standing);

  ParticleMotionOptions options_;
  Duration window_;
  std::vector<TimedPose> poses_;  ///< circular
  std::size_t first_ = 0;
  std::size_t size_ = 0;
  TimedPose newest_;
  Time last_wheel_;
  Twist2 twist_;
  double odometer_ = 0.0;
  Gyro gyro_;
  double gyro_bias_ = 0.0;
  double stood_ = 0.0;  ///< [s] that the bias was learnt over
  UncertainMotion behind_;
};

}  // namespace bw::localization
