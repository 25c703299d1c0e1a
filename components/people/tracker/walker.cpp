#include "components/people/tracker/walker.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

#include "components/people/tracker/heading_model.hpp"

namespace bw::people {
namespace {

constexpr double kWalking = 0.2;  // [m/s] the direction of a slower velocity says nothing (theory.md 7.3)

using Block2 = Eigen::Matrix2d;

}  // namespace

Walker::Walker(const Vector2& first_leg, const Vector2& second_leg, const Vector2& velocity,
               double leg_variance, double velocity_variance) {
  x_ << (first_leg + second_leg) / 2.0, velocity, (first_leg - second_leg) / 2.0, 0.0, 0.0;
  P_.diagonal() << Vector2::Constant(leg_variance / 2.0), Vector2::Constant(velocity_variance),
      Vector2::Constant(leg_variance / 2.0), Vector2::Constant(velocity_variance + 0.1);
}

Walker::Walker(const WalkerOptions& options, BodyPart part, const Vector2& position, const Vector2& velocity,
               double variance, double velocity_variance) {
  const double leg = options.kHalfWidth * options.kHalfWidth;
  x_ << position, velocity, 0.0, 0.0, 0.0, 0.0;
  const double s = sign(part);
  // position = p + s h, so p and h are as uncertain as a leg is far, together only as uncertain as the
  // position.
  P_.diagonal() << Vector2::Constant(variance + (s == 0.0 ? 0.0 : leg)), Vector2::Constant(velocity_variance),
      Vector2::Constant(leg), Vector2::Constant(0.3);
  P_(0, 4) = P_(4, 0) = P_(1, 5) = P_(5, 1) = -s * leg;
}

double Walker::sign(BodyPart part) {
  return part == BodyPart::first_leg ? 1.0 : part == BodyPart::second_leg ? -1.0 : 0.0;
}

void Walker::predict(double dt, const WalkerOptions& options) {
  if (dt <= 0.0) return;
  const double speed = velocity().norm();
  const double walking = std::clamp(speed / (2.0 * kWalking), 0.0, 1.0);
  const Vector2 heading = speed > 1e-6 ? Vector2(velocity() / speed) : Vector2(1.0, 0.0);
  const Block2 along = walking * heading * heading.transpose();
  const Block2 across = Block2::Identity() - along;

  // The swing: exact over dt with the beat of the present speed, fading by its memory.
  const double w = std::max(2.0 * std::numbers::pi * speed / options.kStride, 1e-3);
  const double fade = std::exp(-dt / options.kBeatMemory);
  const double c = std::cos(w * dt);
  const double s = std::sin(w * dt);

  Covariance F = Covariance::Identity();
  F.topLeftCorner<4, 4>() = glide(dt);
  F.block<2, 2>(4, 4) = fade * c * along + across;
  F.block<2, 2>(4, 6) = fade * s / w * along;
  F.block<2, 2>(6, 4) = -fade * w * s * along;
  F.block<2, 2>(6, 6) = fade * c * along;

  const double spread = std::lerp(options.kAccelerationStanding, options.kAccelerationWalking, walking);
  const double reach = options.kSwing * std::min(1.0, speed / options.kFullSwingSpeed);
  const double swing = (1.0 - fade * fade) * reach * reach / 2.0;  // keeps the variance of a sine
  const double drift = options.kDriftAcross * options.kDriftAcross * dt;

  Covariance Q = Covariance::Zero();
  Q.topLeftCorner<4, 4>() = glide_noise(dt, spread);
  Q.block<2, 2>(4, 4) = swing * along + drift * Block2::Identity();
  Q.block<2, 2>(6, 6) = w * w * swing * along + 0.3 * dt * Block2::Identity();

  x_ = F * x_;
  P_ = (F * P_ * F.transpose() + Q).eval();
}

Vector2 Walker::expected(BodyPart part) const { return x_.head<2>() + sign(part) * x_.segment<2>(4); }

Eigen::Matrix2d Walker::spread(BodyPart part) const {
  const double s = sign(part);
  const Block2 ph = P_.block<2, 2>(0, 4);
  return P_.block<2, 2>(0, 0) + s * (ph + ph.transpose()) + s * s * P_.block<2, 2>(4, 4);
}

double Walker::correct(BodyPart part, const Vector2& position, const Eigen::Matrix2d& R,
                       const WalkerOptions& options) {
  const Vector2 innovation = position - expected(part);
  double distance = innovation.dot((spread(part) + R).ldlt().solve(innovation));
  if (distance > options.kJumpGate) {  // a turn or a start: let the velocity and the legs follow
    const double speed = options.kJumpSpeed * options.kJumpSpeed;
    const double leg = options.kJumpLeg * options.kJumpLeg;
    P_.diagonal() += (State() << 0.1 * leg, 0.1 * leg, speed, speed, leg, leg, speed, speed).finished();
  }
  const double s = sign(part);
  const Eigen::Matrix<double, 8, 2> PHt = P_.leftCols<2>() + s * P_.middleCols<2>(4);
  const Block2 S = spread(part) + R;
  const Eigen::Matrix<double, 8, 2> K = S.ldlt().solve(PHt.transpose()).transpose();
  x_ += K * innovation;
  // Joseph form, expanded: P - K (PH')' - (PH') K' + K S K'.
  const Covariance KHP = K * PHt.transpose();
  P_ += K * S * K.transpose() - KHP - KHP.transpose();
  P_ = (0.5 * (P_ + P_.transpose())).eval();
  return distance;
}

void Walker::place_middle(const Eigen::Vector4d& motion, const Eigen::Matrix4d& covariance) {
  x_.head<4>() = motion;
  P_.topLeftCorner<4, 4>() = covariance;
  P_.topRightCorner<4, 4>().setZero();
  P_.bottomLeftCorner<4, 4>().setZero();
}

double Walker::position_sigma() const {
  const Block2 p = P_.topLeftCorner<2, 2>();
  const double mean = p.trace() / 2.0;
  const double half = (p(0, 0) - p(1, 1)) / 2.0;
  return std::sqrt(std::max(0.0, mean + std::sqrt(half * half + p(0, 1) * p(0, 1))));
}

}  // namespace bw::people
