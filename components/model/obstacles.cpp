#include "components/model/obstacles.hpp"

#include <algorithm>
#include <cmath>

namespace bw {
namespace {

// Root of the larger eigenvalue of a symmetric 2x2 matrix.
double largest_sigma(const Eigen::Matrix2d& covariance) {
  const double mean = 0.5 * covariance.trace();
  const double half_difference = 0.5 * (covariance(0, 0) - covariance(1, 1));
  return std::sqrt(std::max(0.0, mean + std::hypot(half_difference, covariance(0, 1))));
}

}  // namespace

Vector2 Mover::position_at(double t) const {
  double t0 = 0.0;
  Vector2 p0 = position;
  Vector2 velocity_after = velocity;
  for (const PredictedPosition& next : predictions) {
    if (next.time <= t0) continue;
    velocity_after = (next.position - p0) / (next.time - t0);
    if (t <= next.time) break;
    t0 = next.time;
    p0 = next.position;
  }
  return p0 + velocity_after * (t - t0);
}

double Mover::sigma_at(double t) const {
  double t0 = 0.0;
  double sigma = 0.0;
  double rate = 0.0;
  for (const PredictedPosition& next : predictions) {
    const double next_sigma = largest_sigma(next.covariance);
    if (next.time <= t0) {
      sigma = next_sigma;
      continue;
    }
    rate = (next_sigma - sigma) / (next.time - t0);
    if (t <= next.time) return sigma + rate * (t - t0);
    t0 = next.time;
    sigma = next_sigma;
  }
  return sigma + std::max(rate, 0.0) * (t - t0);
}

double Mover::top_speed() const {
  double speed = velocity.norm();
  double t0 = 0.0;
  Vector2 p0 = position;
  for (const PredictedPosition& next : predictions) {
    if (next.time <= t0) continue;
    speed = std::max(speed, (next.position - p0).norm() / (next.time - t0));
    t0 = next.time;
    p0 = next.position;
  }
  return speed;
}

}  // namespace bw
