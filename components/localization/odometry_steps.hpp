// Wheel steps from the messages of an odometry, with the noise that it declares itself.
#pragma once

#include <optional>

#include "components/model/wheel_step.hpp"

namespace bw::localization {

class OdometrySteps {
 public:
  static constexpr double kUndeclaredNoise = 5e-4;  ///< [m]: 2 cm after one metre of a wheel

  OdometrySteps() = default;
  /// `noise`: k of model/README.md 2.2 [m]; 0: as the variance of the odometry's heading grows,
  /// kUndeclaredNoise where it does not.
  /// `tick`: travel of a wheel between two counts [m]; 0: not known.
  OdometrySteps(int source, double separation, double noise, double tick = 0.0)
      : source_(source),
        separation_(separation),
        noise_(noise),
        rounding_(rotation_rounding(tick, separation)) {}

  void set_noise(double noise) { noise_ = noise; }

  /// Nothing for the first pose, and after a clock that went back.
  std::optional<WheelStep> add(Time time, const Pose2& X_OB, double heading_variance) {
    const std::optional<Pose2> before = X_OB_;
    const Duration over = time - time_;
    const double variance_before = heading_variance_;
    X_OB_ = X_OB;
    time_ = time;
    heading_variance_ = heading_variance;
    if (!before || over.nanoseconds <= 0) return std::nullopt;
    const ArcTravel arc = arc_between(*before, X_OB);
    const double k = noise_ > 0.0
                         ? noise_
                         : declared_variance_per_metre(variance_before, heading_variance, arc, separation_)
                               .value_or(kUndeclaredNoise);
    WheelStep step = step_from_poses(time, over, *before, X_OB, separation_, k);
    step.source = source_;
    step.rounding = rounding_;
    return step;
  }

  const std::optional<Pose2>& X_OB() const { return X_OB_; }  ///< the newest
  Time time() const { return time_; }                         ///< of the newest

 private:
  int source_ = 0;
  double separation_ = 1.0;  ///< of the wheels [m]
  double noise_ = 0.0;
  double rounding_ = 0.0;  ///< WheelStep::rounding [rad^2]
  std::optional<Pose2> X_OB_;
  Time time_;
  double heading_variance_ = 0.0;  ///< of the newest, as declared [rad^2]
};

}  // namespace bw::localization
