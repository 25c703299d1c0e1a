// Follows one person's annotations as the reference figures do (experiments/protocols.md 8.7): a constant-velocity Kalman
// filter, measurement noise 0.05 m, white acceleration 0.3 m^2/s^3.
#pragma once

#include <Eigen/LU>

#include "components/model/tracked_person.hpp"

namespace bw::people {

class WalkerFilter {
 public:
  explicit WalkerFilter(const Vector2& position) {
    x_ << position.x(), position.y(), 0.0, 0.0;
    P_.diagonal() << kNoise * kNoise, kNoise * kNoise, 2.0, 2.0;
  }

  void update(const Vector2& position, double dt) {
    Eigen::Matrix4d F = Eigen::Matrix4d::Identity();
    F(0, 2) = F(1, 3) = dt;
    Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
    for (int i = 0; i < 2; ++i) {
      Q(i, i) = kAcceleration * dt * dt * dt / 3.0;
      Q(i, i + 2) = Q(i + 2, i) = kAcceleration * dt * dt / 2.0;
      Q(i + 2, i + 2) = kAcceleration * dt;
    }
    x_ = F * x_;
    P_ = F * P_ * F.transpose() + Q;
    const Eigen::Matrix2d S = P_.topLeftCorner<2, 2>() + kNoise * kNoise * Eigen::Matrix2d::Identity();
    const Eigen::Matrix<double, 4, 2> K = P_.leftCols<2>() * S.inverse();
    x_ += K * (position - x_.head<2>());
    P_ = (P_ - K * P_.topRows<2>()).eval();
    P_ = 0.5 * (P_ + P_.transpose()).eval();
  }

  TrackedPerson state(std::uint32_t id) const {
    return {{.id = id, .position = x_.head<2>(), .velocity = x_.tail<2>()}, P_};
  }

 private:
  static constexpr double kNoise = 0.05;        // [m]
  static constexpr double kAcceleration = 0.3;  // [m^2/s^3]
  Eigen::Vector4d x_;
  Eigen::Matrix4d P_ = Eigen::Matrix4d::Zero();
};

}  // namespace bw::people
