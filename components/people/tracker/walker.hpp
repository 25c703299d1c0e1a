// How somebody on two legs moves: a linear filter over the point between the legs and the legs' swing.
//
//   state (p, v, h, g): position between the legs [m], its velocity [m/s], from there to the first leg [m],
//   and its rate [m/s]; the legs are at p + h and p - h.
//
//   p' = v                        with white acceleration (more when walking than when standing)
//   h, along the path:  h'' = -w^2 h - c h' + noise, w = 2 pi |v| / stride: one swing per two steps
//   h, across:         slow drift
//
// So a walker of whom one leg is seen does not seem to hurry and wait with each step, as the leg does (it
// moves at 0 to 2 |v|), and a leg that appears again is expected where it swings. The noise of the swing
// follows from how far legs swing and how long they keep the beat, that its variance stays what it is.
// The path has the direction of v; while |v| is small, legs hold still.
#pragma once

#include <Eigen/Core>

#include "runtime/base/field.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::people {

struct WalkerOptions {
  /// [m/s^2/sqrt(Hz)] how fast people who stand begin to move, as legs are assigned
  static constexpr double kAccelerationStanding = 0.2;
  /// [m/s^2/sqrt(Hz)] how fast people who walk change their velocity, as legs are assigned
  static constexpr double kAccelerationWalking = 0.6;
  /// [m] distance of two steps: one swing
  static constexpr double kStride = 1.4;
  /// [m] reach of a leg, forward or back, at full swing
  static constexpr double kSwing = 0.18;
  /// [m/s] below this speed legs swing less, in proportion
  static constexpr double kFullSwingSpeed = 1.3;
  /// [s] how long a swing keeps its beat
  static constexpr double kBeatMemory = 1.0;
  /// [m/sqrt(s)] how fast the distance between the legs changes
  static constexpr double kDriftAcross = 0.08;
  /// [m] standard deviation of the position of a leg that nobody has seen, from the middle, per axis
  static constexpr double kHalfWidth = 0.13;
  /// squared standard deviations (2 dof) beyond which a step was not foreseen: filter widens
  static constexpr double kJumpGate = 25.0;
  /// [m/s] added then to the spread of the velocity
  static constexpr double kJumpSpeed = 0.7;
  /// [m] added then to the spread of the legs
  static constexpr double kJumpLeg = 0.08;
};

/// What of a person is seen at a position.
enum class BodyPart { first_leg, second_leg, middle };

class Walker {
 public:
  using State = Eigen::Matrix<double, 8, 1>;
  using Covariance = Eigen::Matrix<double, 8, 8>;

  /// Both legs seen, moving with velocity v [m/s] of covariance `velocity_variance` I.
  Walker(const Vector2& first_leg, const Vector2& second_leg, const Vector2& velocity, double leg_variance,
         double velocity_variance);

  /// One leg seen (or the middle, when `part` says so): the other is somewhere about.
  Walker(const WalkerOptions& options, BodyPart part, const Vector2& position, const Vector2& velocity,
         double variance, double velocity_variance);

  void predict(double dt, const WalkerOptions& options);  ///< dt >= 0 [s]

  /// Where the part is expected, and how surely.
  Vector2 expected(BodyPart part) const;
  Eigen::Matrix2d spread(BodyPart part) const;

  /// Corrects by a position seen with covariance R [m^2]. Returns the squared distance in standard deviations
  /// before the correction.
  double correct(BodyPart part, const Vector2& position, const Eigen::Matrix2d& R,
                 const WalkerOptions& options);

  /// Knows the middle and its velocity (x, y, vx, vy) from elsewhere; the legs go on swinging.
  void place_middle(const Eigen::Vector4d& motion, const Eigen::Matrix4d& covariance);

  Vector2 position() const { return x_.head<2>(); }
  Vector2 velocity() const { return x_.segment<2>(2); }
  Vector2 to_first_leg() const { return x_.segment<2>(4); }
  Eigen::Matrix4d covariance() const { return P_.topLeftCorner<4, 4>(); }
  double position_sigma() const;  ///< largest standard deviation [m]

 private:
  static double sign(BodyPart part);

  State x_ = State::Zero();
  Covariance P_ = Covariance::Zero();
};

}  // namespace bw::people
