// The equations of the filter of headings against numerical derivatives and closed forms.
#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "components/people/tracker/heading_model.hpp"

namespace bw::people {
namespace {

/// Central differences of a function of a vector; their own error is about 1e-9 here.
template <class Function, class Vector>
Eigen::MatrixXd numerical(const Function& f, const Vector& x) {
  constexpr double kStep = 1e-5;
  Eigen::MatrixXd J(f(x).size(), x.size());
  for (int i = 0; i < x.size(); ++i) {
    Vector more = x;
    Vector less = x;
    more[i] += kStep;
    less[i] -= kStep;
    J.col(i) = (f(more) - f(less)) / (2.0 * kStep);
  }
  return J;
}

HeadingState any_state(Random& random) {
  HeadingState x;
  x << random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-3.1, 3.1), random.uniform(-2, 2);
  return x;
}

TEST(HeadingModel, JacobiansAreThoseOfTheEquations) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const HeadingState x = any_state(random);
    const double dt = random.uniform(0.01, 0.5);
    const auto step = [&](const HeadingState& s) { return walked(s, dt); };
    EXPECT_LE((walked_jacobian(x, dt) - numerical(step, x)).cwiseAbs().maxCoeff(), 1e-6);
    // Small errors: the covariance is J P J^T, but for terms of the order of P^2.
    HeadingCovariance L;
    for (double& element : L.reshaped()) element = random.uniform(-1e-4, 1e-4);
    const HeadingCovariance P = L * L.transpose();
    const Eigen::MatrixXd J = numerical(without_heading, x);
    EXPECT_LE((covariance_without_heading(x, P) - J * P * J.transpose()).cwiseAbs().maxCoeff(), 1e-13);
    if (std::abs(x[3]) < 0.1) continue;  // a velocity of zero has no heading to differentiate
    const Eigen::Vector4d m = without_heading(x);
    EXPECT_LE((with_heading_jacobian(m) - numerical(with_heading, m)).cwiseAbs().maxCoeff(), 1e-6);
  }
}

TEST(HeadingModel, FormsAreInverse) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    HeadingState x = any_state(random);
    x[3] = std::abs(x[3]) + 0.1;
    EXPECT_LE((with_heading(without_heading(x)) - x).norm(), 1e-12);
  }
}

// A heading that is worth little, against 400000 draws: the standard error of each element is below
// sqrt(2 / 400000) = 0.22 % of the product of the two standard deviations.
TEST(HeadingModel, CovarianceIsThatOfDraws) {
  HeadingState x;
  x << 1.0, -2.0, 0.6, 0.4;
  HeadingCovariance L;
  L << 0.1, 0.0, 0.0, 0.0, 0.03, 0.1, 0.0, 0.0, 0.2, -0.1, 0.7, 0.0, 0.05, 0.08, -0.1, 0.2;
  Random random(4);
  Eigen::Matrix4d drawn = Eigen::Matrix4d::Zero();
  constexpr int kDraws = 400000;
  for (int i = 0; i < kDraws; ++i) {
    HeadingState z = HeadingState::Zero();
    for (int k = 0; k < 4; ++k) z[k] = random.normal();
    const Eigen::Vector4d error = without_heading(x + L * z) - without_heading(x);
    drawn += error * error.transpose() / kDraws;
  }
  const Eigen::Matrix4d C = covariance_without_heading(x, L * L.transpose());
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) EXPECT_NEAR(C(i, j), drawn(i, j), 0.01 * std::sqrt(C(i, i) * C(j, j)));
}

// On a straight path the model is linear: the noise of 0.4 s is that of 400 steps of 1 ms, each
// carried on to the end. This holds for the integrals only if every power of dt and every factor is right.
TEST(HeadingModel, NoiseOfManyStepsIsThatOfOne) {
  const HeadingNoise noise{0.5, 0.8};
  HeadingState x;
  x << 1.0, 2.0, 2.5, 1.4;
  HeadingCovariance many = HeadingCovariance::Zero();
  HeadingState at = x;
  for (int k = 0; k < 400; ++k) {
    const HeadingCovariance F = walked_jacobian(at, 1e-3);
    many = (F * many * F.transpose() + walked_noise(at, 1e-3, noise)).eval();
    at = walked(at, 1e-3);
  }
  EXPECT_LE((many - walked_noise(x, 0.4, noise)).cwiseAbs().maxCoeff(), 1e-9);

  Eigen::Matrix4d glided = Eigen::Matrix4d::Zero();
  for (int k = 0; k < 400; ++k)
    glided = (glide(1e-3) * glided * glide(1e-3).transpose() + glide_noise(1e-3, 0.8)).eval();
  EXPECT_LE((glided - glide_noise(0.4, 0.8)).cwiseAbs().maxCoeff(), 1e-12);
}

// Whoever walks straight with noise q along and v^2 q across obeys the same noise in either form:
// acceleration a along is a on v, and a across is a / v on theta.
TEST(HeadingModel, NoiseAgreesWithThatOfConstantVelocity) {
  HeadingState x;
  x << 0.0, 0.0, 0.7, 1.6;
  const HeadingCovariance Q = walked_noise(x, 0.3, {0.5 / 1.6, 0.5});
  const HeadingCovariance J = with_heading_jacobian(without_heading(x));
  EXPECT_LE((J * glide_noise(0.3, 0.5) * J.transpose() - Q).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace bw::people
