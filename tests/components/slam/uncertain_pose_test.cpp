#include "components/slam/uncertain_pose.hpp"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw::slam {
namespace {

constexpr double kStep = 1e-5;  // central differences: error of order h^2 = 1e-10

Pose2 moved(const Pose2& X, int axis, double by) {
  Pose2 result = X;
  (axis == 0 ? result.x : axis == 1 ? result.y : result.theta) += by;
  return result;
}

template <class Function>
Eigen::Matrix3d numerical(const Pose2& at, const Function& f) {
  Eigen::Matrix3d J;
  for (int k = 0; k < 3; ++k)
    J.col(k) = difference(f(moved(at, k, kStep)), f(moved(at, k, -kStep))) / (2.0 * kStep);
  return J;
}

Pose2 any_pose(Random& random) {
  return {random.uniform(-10, 10), random.uniform(-10, 10), random.uniform(-3.1, 3.1)};
}

Eigen::Matrix3d any_covariance(Random& random, double metres, double radians) {
  Eigen::Matrix3d A;
  for (int i = 0; i < 9; ++i) A(i) = random.normal();
  const Eigen::Vector3d scale{metres, metres, radians};
  return scale.asDiagonal() * (A * A.transpose() / 3.0 + 0.1 * Eigen::Matrix3d::Identity()) *
         scale.asDiagonal();
}

TEST(UncertainPose, JacobiansMatchNumericalDerivativesWithin1e8) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    const Pose2 X_AB = any_pose(random);
    const Pose2 X_BC = any_pose(random);
    const auto first = numerical(X_AB, [&](const Pose2& X) { return X * X_BC; });
    ASSERT_LT((by_first(X_AB, X_BC) - first).norm(), 1e-8) << "seed " << seed;
    const auto second = numerical(X_BC, [&](const Pose2& X) { return X_AB * X; });
    ASSERT_LT((by_second(X_AB) - second).norm(), 1e-8) << "seed " << seed;
    const auto J = numerical(X_AB, [](const Pose2& X) { return bw::inverse(X); });
    const Eigen::Matrix3d C = any_covariance(random, 1.0, 1.0);
    const Eigen::Matrix3d expected = J * C * J.transpose();
    ASSERT_LT((inverse(UncertainPose{X_AB, C}).covariance - expected).norm(), 1e-7 * expected.norm())
        << "seed " << seed;
  }
}

TEST(UncertainPose, InverseOfTheInverseIsThePose) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const UncertainPose X{any_pose(random), any_covariance(random, 0.2, 0.1)};
    const UncertainPose twice = inverse(inverse(X));
    ASSERT_LT(difference(twice.X, X.X).norm(), 1e-12);
    ASSERT_LT((twice.covariance - X.covariance).norm(), 1e-12 * (1.0 + X.covariance.norm()));
  }
}

// Errors are added to (x, y, theta), as the type says; 100,000 draws tell an entry to 0.5 % (sqrt(2 / n)),
// and what is left out is of second order: 0.01 rad.
TEST(UncertainPose, CovarianceOfACompositionIsThatOfDraws) {
  constexpr int kDraws = 100000;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    const UncertainPose a{any_pose(random), any_covariance(random, 0.05, 0.01)};
    const UncertainPose b{any_pose(random), any_covariance(random, 0.05, 0.01)};
    const UncertainPose composed = a * inverse(b);
    const Eigen::Matrix3d La = a.covariance.llt().matrixL();
    const Eigen::Matrix3d Lb = b.covariance.llt().matrixL();
    const auto drawn = [&](const UncertainPose& X, const Eigen::Matrix3d& L) -> Pose2 {
      const Eigen::Vector3d e = L * Eigen::Vector3d{random.normal(), random.normal(), random.normal()};
      return {X.X.x + e.x(), X.X.y + e.y(), X.X.theta + e.z()};
    };
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (int i = 0; i < kDraws; ++i) {
      const Eigen::Vector3d e = difference(drawn(a, La) * bw::inverse(drawn(b, Lb)), composed.X);
      sum += e * e.transpose();
    }
    const Eigen::Vector3d sigma = composed.covariance.diagonal().cwiseSqrt();
    const Eigen::Matrix3d off = (sum / kDraws - composed.covariance).cwiseQuotient(sigma * sigma.transpose());
    EXPECT_LT(off.cwiseAbs().maxCoeff(), 0.025) << "seed " << seed;
  }
}

}  // namespace
}  // namespace bw::slam
