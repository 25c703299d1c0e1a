// The gait filter against walkers whose motion is known in closed form.
#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "components/people/tracker/walker.hpp"

namespace bw::people {
namespace {

constexpr double kPeriod = 0.1;
constexpr double kNoise = 0.012;

/// Walks along +x at `speed`; legs swing by +-0.18 m at 1.3 m/s with a stride of 1.4 m, 0.24 m apart.
struct Legs {
  Vector2 middle, left, right;
};
Legs legs_at(double t, double speed) {
  const double swing = 0.18 * std::min(1.0, speed / 1.3) * std::sin(2.0 * std::numbers::pi * speed * t / 1.4);
  const Vector2 middle(speed * t, 0.0);
  return {middle, middle + Vector2(swing, 0.12), middle + Vector2(-swing, -0.12)};
}

Vector2 noisy(const Vector2& p, Random& random) {
  const double x = random.normal(0.0, kNoise);
  return p + Vector2(x, random.normal(0.0, kNoise));
}

const Eigen::Matrix2d kR = kNoise * kNoise * Eigen::Matrix2d::Identity();

/// Root mean square error of the velocity from second 1 to second 6. `sees`: whether the right leg is seen.
template <class Sees>
double velocity_error(double speed, std::uint64_t seed, const Sees& sees) {
  Random random(seed);
  const WalkerOptions options;
  const Legs start = legs_at(0.0, speed);
  Walker walker(noisy(start.left, random), noisy(start.right, random), {0.0, 0.0}, kNoise * kNoise, 1.0);
  double square = 0.0;
  int count = 0;
  for (int k = 1; k <= 60; ++k) {
    const double t = k * kPeriod;
    const Legs legs = legs_at(t, speed);
    walker.predict(kPeriod, options);
    walker.correct(BodyPart::first_leg, noisy(legs.left, random), kR, options);
    const Vector2 right = noisy(legs.right, random);
    if (sees(t)) walker.correct(BodyPart::second_leg, right, kR, options);
    if (t < 1.0) continue;
    square += (walker.velocity() - Vector2(speed, 0.0)).squaredNorm();
    ++count;
  }
  return std::sqrt(square / count);
}

// A single leg moves at 0 to 2 |v|: its own velocity is off by 0.74 m/s root mean square at 1.3 m/s
// (0.18 w / sqrt 2, w = 2 pi 1.3 / 1.4 = 5.83 rad/s). Asked of a person: 0.15 m/s.
TEST(Walker, VelocityDoesNotSwingWithTheLegs) {
  for (const double speed : {0.0, 0.3, 0.8, 1.3}) {
    double mean = 0.0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
      mean += velocity_error(speed, seed, [](double) { return true; }) / 20.0;
    EXPECT_LE(mean, 0.15) << "at " << speed << " m/s";
  }
}

TEST(Walker, VelocityHoldsWhileOneLegIsHidden) {
  double mean = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    mean += velocity_error(1.2, seed, [](double t) { return t < 2.0 || t > 3.0; }) / 20.0;
  EXPECT_LE(mean, 0.15);
}

// Both legs seen: the squared error of (x, y, vx, vy) over the covariance has mean 4 when the covariance
// tells the truth; a filter that allows for turns, on somebody who walks straight, is below, but must never
// be above.
TEST(Walker, CovarianceHoldsTheError) {
  const WalkerOptions options;
  double sum = 0.0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const Legs start = legs_at(0.0, 1.0);
    Walker walker(noisy(start.left, random), noisy(start.right, random), {0.0, 0.0}, kNoise * kNoise, 1.0);
    for (int k = 1; k <= 30; ++k) {
      const Legs legs = legs_at(k * kPeriod, 1.0);
      walker.predict(kPeriod, options);
      walker.correct(BodyPart::first_leg, noisy(legs.left, random), kR, options);
      walker.correct(BodyPart::second_leg, noisy(legs.right, random), kR, options);
      if (k < 10) continue;
      Eigen::Vector4d error;
      error << walker.position() - legs.middle, walker.velocity() - Vector2(1.0, 0.0);
      const Eigen::Matrix4d P = walker.covariance();
      EXPECT_GT(P.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0.0);
      sum += error.dot(P.ldlt().solve(error));
      ++count;
    }
  }
  EXPECT_LE(sum / count, 4.4);
  EXPECT_GE(sum / count, 0.4);
}

// 1 s without a measurement at the walking noise q = 0.6: sd of the velocity 0.6, of the position at least
// 0.6 / sqrt 3 = 0.35 m.
TEST(Walker, GrowsUnsureWhileUnseen) {
  const WalkerOptions options;
  Walker walker({0.0, 0.12}, {0.0, -0.12}, {1.2, 0.0}, 1e-4, 1e-4);
  for (int k = 0; k < 10; ++k) walker.predict(kPeriod, options);
  EXPECT_NEAR(walker.position().x(), 1.2, 1e-9);
  EXPECT_NEAR(walker.position_sigma(), 0.6 / std::sqrt(3.0), 0.02);
}

}  // namespace
}  // namespace bw::people
