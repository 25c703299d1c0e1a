// The extended Kalman filter of theory.md 7.3: position, heading and speed of somebody, from positions where
// they were seen. While they stand, or nearly, a velocity shows no heading: then the state is (x, y, vx, vy).
//
// The covariance goes from velocities to a heading by the derivative, and back by the exact moments, as the
// derivative is wrong where the heading is worth little.
//
// Predict a copy to look ahead: its position, velocity and covariance are those of then.
#pragma once

#include "components/people/tracker/heading_model.hpp"

namespace bw::people {

/// theory.md 7.3 compares the defaults with heading_noise 0.5, acceleration 0.8 for both, position_noise
/// 0.05.
struct HeadingOptions {
  /// [rad/s/sqrt(Hz)] how fast people who walk change direction (set by code alone)
  double heading_noise = 0.7;
  /// [m/s^2/sqrt(Hz)] how fast people who walk change their speed (set by code alone)
  double acceleration = 0.8;
  /// [m/s^2/sqrt(Hz)] how fast people who stand begin to move (set by code alone)
  double acceleration_standing = 0.3;
  /// [m/s] below this speed a velocity has no heading; at its maximum this is a constant-velocity filter (set
  /// by code alone)
  double walking_speed = 0.2;
  /// [m] standard deviation of the middle between the legs, beyond that of the legs (set by code alone)
  double position_noise = 0.02;
};

/// A position where somebody was seen.
struct SeenPosition {
  Vector2 position{0.0, 0.0};                                       ///< [m]
  Eigen::Matrix2d covariance = 0.01 * Eigen::Matrix2d::Identity();  ///< positive definite [m^2]
};

class HeadingFilter {
 public:
  HeadingFilter() = default;  ///< nobody yet

  /// Seen at two positions, `dt` > 0 [s] apart.
  HeadingFilter(const SeenPosition& first, const SeenPosition& second, double dt,
                const HeadingOptions& options);

  /// Known as (x, y, vx, vy) with its covariance.
  HeadingFilter(const Eigen::Vector4d& motion, const Eigen::Matrix4d& covariance,
                const HeadingOptions& options);

  void predict(double dt, const HeadingOptions& options);  ///< dt >= 0 [s]

  void correct(const SeenPosition& seen, const HeadingOptions& options);

  Vector2 position() const { return x_.head<2>(); }
  Vector2 velocity() const;
  Eigen::Matrix4d covariance() const;  ///< of (x, y, vx, vy), as the filter foresees
  /// As it turns out. The noise that lets the filter follow turns and stops is too much for the rest of the time: a
  /// velocity is as sure as the last innovations were small.
  Eigen::Matrix4d true_covariance() const;

  bool walks() const { return walks_; }  ///< whether there is a heading

 private:
  void choose_form(const HeadingOptions& options);

  bool walks_ = false;
  double surprise_ = 1.0;                  ///< mean squared innovation over what was foreseen, lately
  double since_ = 0.0;                     ///< predicted since the last correction [s]
  HeadingState x_ = HeadingState::Zero();  ///< (x, y, theta, v), or (x, y, vx, vy)
  HeadingCovariance P_ = HeadingCovariance::Zero();
};

}  // namespace bw::people
