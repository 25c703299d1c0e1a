#include "components/local_planner/mppi/controls.hpp"

#include <algorithm>
#include <cmath>

namespace bw::mppi {
namespace {

// Of a parabola through nine points by least squares (Savitzky and Golay 1964).
constexpr std::array<double, 9> kWindow{-21.0, 14.0, 39.0, 54.0, 59.0, 54.0, 39.0, 14.0, -21.0};
constexpr double kWindowSum = 231.0;
constexpr Eigen::Index kHalfWindow = 4;
constexpr Eigen::Index kFewestSteps = 21;

void limit_changes(Eigen::ArrayXd& sequence, double low, double high, double most) {
  for (Eigen::Index k = 0; k < sequence.size(); ++k) {
    sequence[k] = std::clamp(sequence[k], low, high);
    if (k > 0) sequence[k] = std::clamp(sequence[k], sequence[k - 1] - most, sequence[k - 1] + most);
  }
}

Eigen::ArrayXd smoothed(const Eigen::ArrayXd& sequence, const std::array<double, kHalfWindow>& before) {
  const Eigen::Index count = sequence.size();
  Eigen::ArrayXd padded(count + 2 * kHalfWindow);
  for (Eigen::Index k = 0; k < kHalfWindow; ++k) padded[k] = before[static_cast<std::size_t>(k)];
  padded.segment(kHalfWindow, count) = sequence;
  padded.tail(kHalfWindow).setConstant(sequence[count - 1]);
  Eigen::ArrayXd result = sequence;
  for (Eigen::Index k = 0; k + 1 < count; ++k) {
    double sum = 0.0;
    for (std::size_t j = 0; j < kWindow.size(); ++j)
      sum += kWindow[j] * padded[k + static_cast<Eigen::Index>(j)];
    result[k] = sum / kWindowSum;
  }
  return result;
}

}  // namespace

void Controls::reset(Eigen::Index steps) {
  v = Eigen::ArrayXd::Zero(steps);
  omega = Eigen::ArrayXd::Zero(steps);
  before_ = {};
}

Twist2 Controls::at(double steps) const {
  const double first = -static_cast<double>(kHalfWindow);
  const double index = std::clamp(steps, first, static_cast<double>(v.size() - 1));
  const auto below = static_cast<Eigen::Index>(std::floor(index));
  const double share = index - static_cast<double>(below);
  const auto element = [&](Eigen::Index k) {
    if (k < 0) return before_[static_cast<std::size_t>(k + kHalfWindow)];
    k = std::min(k, v.size() - 1);
    return Twist2{v[k], omega[k]};
  };
  const Twist2 a = element(below);
  if (share == 0.0) return a;
  const Twist2 b = element(below + 1);
  return {(1.0 - share) * a.v + share * b.v, (1.0 - share) * a.omega + share * b.omega};
}

void Controls::limit(const Limits& limits, double dt) {
  limit_changes(v, -limits.v_back_max, limits.v_max, limits.acc_max * dt);
  limit_changes(omega, -limits.omega_max, limits.omega_max, limits.alpha_max * dt);
}

void Controls::smooth() {
  if (steps() < kFewestSteps) return;
  std::array<double, kHalfWindow> before_v{}, before_omega{};
  for (std::size_t k = 0; k < before_.size(); ++k) {
    before_v[k] = before_[k].v;
    before_omega[k] = before_[k].omega;
  }
  v = smoothed(v, before_v);
  omega = smoothed(omega, before_omega);
}

void Controls::shift(double steps) {
  Controls later(v.size());
  for (Eigen::Index k = 0; k < v.size(); ++k) {
    const Twist2 twist = at(static_cast<double>(k) + steps);
    later.v[k] = twist.v;
    later.omega[k] = twist.omega;
  }
  for (std::size_t k = 0; k < before_.size(); ++k)
    later.before_[k] = at(steps + static_cast<double>(k) - static_cast<double>(kHalfWindow));
  *this = std::move(later);
}

}  // namespace bw::mppi
