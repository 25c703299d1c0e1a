// The filter of headings (tracker/theory.md 7.3) against walkers whose motion is known.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "components/people/tracker/heading_filter.hpp"

namespace bw::people {
namespace {

constexpr double kPeriod = 0.1;
constexpr double kNoise = 0.03;

const Eigen::Matrix2d kR = kNoise * kNoise * Eigen::Matrix2d::Identity();

SeenPosition seen(const Vector2& p) { return {p, kR}; }

SeenPosition noisy(const Vector2& p, Random& random) {
  const double x = random.normal(0.0, kNoise);
  return seen(p + Vector2(x, random.normal(0.0, kNoise)));
}

HeadingOptions plain() {
  HeadingOptions options;
  options.heading_noise = 0.5;
  options.acceleration = options.acceleration_standing = 0.8;
  options.walking_speed = 0.2;
  return options;
}

double nees(const HeadingFilter& filter, const Vector2& position, const Vector2& velocity) {
  Eigen::Vector4d error;
  error << filter.position() - position, filter.velocity() - velocity;
  return error.dot(filter.covariance().ldlt().solve(error));
}

// From (1, 2) to (1.3, 2.4) within 0.5 s: velocity (0.6, 0.8) m/s. The last position is as unsure as it was
// seen; the velocity by both positions over 0.5 s, and by 0.8^2 dt / 3 for the acceleration between.
TEST(HeadingFilter, StartsFromTwoPoints) {
  const Eigen::Matrix2d R1 = (Eigen::Matrix2d() << 4e-4, 1e-4, 1e-4, 9e-4).finished();
  const Eigen::Matrix2d R2 = (Eigen::Matrix2d() << 2e-4, -1e-4, -1e-4, 3e-4).finished();
  const HeadingOptions options = plain();
  HeadingOptions standing = options;
  standing.walking_speed = 100.0;
  const HeadingFilter filter({{1.0, 2.0}, R1}, {{1.3, 2.4}, R2}, 0.5, standing);
  EXPECT_LE((filter.position() - Vector2(1.3, 2.4)).norm(), 1e-12);
  EXPECT_LE((filter.velocity() - Vector2(0.6, 0.8)).norm(), 1e-12);
  Eigen::Matrix4d expected;
  expected << R2, R2 / 0.5, R2 / 0.5, (R1 + R2) / 0.25 + 0.64 * 0.5 / 3.0 * Eigen::Matrix2d::Identity();
  EXPECT_LE((filter.covariance() - expected).norm(), 1e-12);
  EXPECT_FALSE(filter.walks());

  // With a heading: the same position and velocity, as unsure of the position.
  const HeadingFilter walking({{1.0, 2.0}, R1}, {{1.3, 2.4}, R2}, 0.5, options);
  EXPECT_TRUE(walking.walks());
  EXPECT_LE((walking.position() - filter.position()).norm(), 1e-12);
  EXPECT_LE((walking.velocity() - filter.velocity()).norm(), 1e-12);
  const Eigen::Matrix2d of_position = walking.covariance().topLeftCorner<2, 2>();
  EXPECT_LE((of_position - R2).norm(), 1e-12);
}

// Speed 0.01 +- 0.2 m/s, heading +- 0.6 rad, across the path: (0.01 * 0.6)^2 = 3.6e-5 by the derivative;
// truly (0.01^2 + 0.2^2) (1 - exp(-2 * 0.36)) / 2.
TEST(HeadingFilter, WhoStopsIsUnsureInEveryDirection) {
  HeadingOptions options = plain();
  options.walking_speed = 0.001;
  options.acceleration = options.heading_noise = 0.01;
  Eigen::Matrix4d C = Eigen::Matrix4d::Zero();
  C.diagonal() << 1e-4, 1e-4, 0.04, 3.6e-5;
  const HeadingFilter filter({0.0, 0.0, 0.01, 0.0}, C, options);
  ASSERT_TRUE(filter.walks());
  EXPECT_NEAR(filter.covariance()(3, 3), 0.0401 * (1.0 - std::exp(-0.72)) / 2.0, 1e-9);
}

/// Speed and heading with white noise, integrated in steps of 1 ms.
struct WhiteWalker {
  HeadingState x;
  HeadingNoise noise;

  void step(double dt, Random& random) {
    constexpr double kFine = 1e-3;
    const double root = std::sqrt(kFine);
    for (int i = 0; i < static_cast<int>(std::lround(dt / kFine)); ++i) {
      x.head<2>() += x[3] * kFine * direction(x[2]);
      x[2] += noise.heading * root * random.normal();
      x[3] += noise.acceleration * root * random.normal();
    }
  }
  Vector2 velocity() const { return x[3] * direction(x[2]); }
};

/// Mean of the squared error of (x, y, vx, vy) over the covariance, at 1, 2 and 3 s, of 500 walkers.
double mean_nees(const HeadingOptions& options, double speed) {
  double sum = 0.0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    Random random(seed);
    WhiteWalker truth{HeadingState::Zero(), {options.heading_noise, options.acceleration}};
    truth.x[2] = random.uniform(-3.1, 3.1);
    truth.x[3] = speed;
    const SeenPosition first = noisy(truth.x.head<2>(), random);
    truth.step(kPeriod, random);
    HeadingFilter filter(first, noisy(truth.x.head<2>(), random), kPeriod, options);
    for (int k = 1; k <= 30; ++k) {
      truth.step(kPeriod, random);
      filter.predict(kPeriod, options);
      filter.correct(noisy(truth.x.head<2>(), random), options);
      if (k % 10 != 0) continue;
      sum += nees(filter, truth.x.head<2>(), truth.velocity());
      ++count;
    }
  }
  return sum / count;
}

// 4 degrees of freedom: mean 4. Of 1500 values, 500 of them independent at least, the mean is within
// 4 +- 3.29 sqrt(8 / 500) = 3.58 to 4.42 in 99.9 % of cases.
TEST(HeadingFilter, CovarianceTellsTheTruth) {
  HeadingOptions options = plain();
  options.acceleration = 0.3;
  const double mean = mean_nees(options, 1.5);
  EXPECT_GE(mean, 3.58);
  EXPECT_LE(mean, 4.42);
}

// Without a heading the filter is linear, and exact: white acceleration, 1500 values, the same bounds.
TEST(HeadingFilter, CovarianceTellsTheTruthOfWhoStands) {
  HeadingOptions options = plain();
  options.walking_speed = 100.0;
  options.acceleration_standing = options.acceleration = 0.3;
  double sum = 0.0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    Random random(seed);
    Eigen::Vector4d truth = Eigen::Vector4d::Zero();
    const auto step = [&] {
      for (int i = 0; i < 100; ++i) {
        truth.head<2>() += 1e-3 * truth.tail<2>();
        const double x = random.normal();
        truth.tail<2>() += 0.3 * std::sqrt(1e-3) * Vector2(x, random.normal());
      }
    };
    const SeenPosition first = noisy(truth.head<2>(), random);
    step();
    HeadingFilter filter(first, noisy(truth.head<2>(), random), kPeriod, options);
    for (int k = 1; k <= 30; ++k) {
      step();
      filter.predict(kPeriod, options);
      filter.correct(noisy(truth.head<2>(), random), options);
      if (k % 10 != 0) continue;
      sum += nees(filter, truth.head<2>(), truth.tail<2>());
      ++count;
    }
  }
  EXPECT_GE(sum / count, 3.58);
  EXPECT_LE(sum / count, 4.42);
}

// The same correction brings one filter below its walking speed and not the other: what they report is the
// same, for that is what is carried over.
TEST(HeadingFilter, StandsStillWithTheCovarianceItHad) {
  const HeadingOptions options = plain();
  HeadingOptions lower = options;
  lower.walking_speed = 0.02;
  Eigen::Matrix4d C = Eigen::Matrix4d::Zero();
  C.diagonal() << 0.01, 0.01, 0.04, 0.04;
  C(0, 2) = C(2, 0) = C(1, 3) = C(3, 1) = 0.01;
  const Eigen::Vector4d m(1.0, 1.0, 0.18, 0.24);
  HeadingFilter stops(m, C, options);
  HeadingFilter walks(m, C, lower);
  const SeenPosition behind = seen({0.88, 0.9});
  stops.correct(behind, options);
  walks.correct(behind, lower);
  ASSERT_FALSE(stops.walks());
  ASSERT_TRUE(walks.walks());
  EXPECT_LE((stops.position() - walks.position()).norm(), 1e-12);
  EXPECT_LE((stops.velocity() - walks.velocity()).norm(), 1e-12);
  EXPECT_LE((stops.covariance() - walks.covariance()).norm(), 1e-12);
}

// And off again: of two that stand, one finds itself above its walking speed, at 0.23 m/s with an sd of 0.06
// m/s each way. The heading's sd of 0.06 / 0.23 = 0.26 rad leaves 3 % to orders beyond the derivative.
TEST(HeadingFilter, WalksOffWithTheCovarianceItHad) {
  const HeadingOptions options = plain();
  HeadingOptions never = options;
  never.walking_speed = 100.0;
  Eigen::Matrix4d C = Eigen::Matrix4d::Zero();
  C.diagonal() << 4e-4, 4e-4, 0.0064, 0.0064;
  C(0, 2) = C(2, 0) = C(1, 3) = C(3, 1) = 0.0014;
  const Eigen::Vector4d m(0.0, 0.0, 0.1, 0.1);
  HeadingFilter walks(m, C, options);
  HeadingFilter stands(m, C, never);
  ASSERT_FALSE(walks.walks());
  const SeenPosition ahead = seen({0.14, 0.09});
  walks.correct(ahead, options);
  stands.correct(ahead, never);
  ASSERT_TRUE(walks.walks());
  ASSERT_FALSE(stands.walks());
  EXPECT_LE((walks.position() - stands.position()).norm(), 1e-12);
  EXPECT_LE((walks.velocity() - stands.velocity()).norm(), 1e-12);
  const Eigen::Matrix4d C_walks = walks.covariance();
  const Eigen::Matrix4d C_stands = stands.covariance();
  const Eigen::Matrix2d of_position = (C_walks - C_stands).topLeftCorner<2, 2>();
  EXPECT_LE(of_position.norm(), 1e-12);
  EXPECT_LE((C_walks - C_stands).norm(), 0.1 * C_stands.norm());
}

HeadingFilter follow(const std::function<SeenPosition(double)>& position, double from, double to,
                     const HeadingOptions& options) {
  HeadingFilter filter(position(from), position(from + kPeriod), kPeriod, options);
  for (double t = from + 2.0 * kPeriod; t < to + 1e-9; t += kPeriod) {
    filter.predict(kPeriod, options);
    filter.correct(position(t), options);
  }
  return filter;
}

TEST(HeadingFilter, FollowsWhoWalksStraight) {
  const Vector2 velocity(-0.9, 0.7);
  const auto position = [&](double t) { return seen(t * velocity); };
  HeadingFilter filter = follow(position, 0.0, 3.0, plain());
  EXPECT_LE((filter.position() - 3.0 * velocity).norm(), 1e-9);
  EXPECT_LE((filter.velocity() - velocity).norm(), 1e-9);
  // 1.6 s ahead, by one step or by many.
  HeadingFilter bits = filter;
  filter.predict(1.6, plain());
  for (int k = 0; k < 16; ++k) bits.predict(0.1, plain());
  EXPECT_LE((filter.position() - 4.6 * velocity).norm(), 1e-9);
  EXPECT_LE((filter.covariance() - bits.covariance()).norm(), 1e-9);
}

// A circle of 1.5 m at 1.2 m/s, 0.8 rad/s, seen without errors: the velocity lags by no more than half a second of the
// turn.
TEST(HeadingFilter, FollowsACircle) {
  const auto position = [](double t) { return seen(1.5 * direction(0.8 * t)); };
  const Vector2 velocity = 1.2 * direction(0.8 * 12.0 + std::numbers::pi / 2.0);
  EXPECT_LE((follow(position, 0.0, 12.0, plain()).velocity() - velocity).norm(), 1.2 * 0.8 * 0.5);
}

// Walks 2 s at 1.2 m/s, then stands for 6 s.
TEST(HeadingFilter, StopsWithWhoStops) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const auto x = [](double t) { return Vector2(1.2 * std::min(t, 2.0), 0.0); };
    const HeadingOptions options = plain();
    HeadingFilter filter(noisy(x(0.0), random), noisy(x(kPeriod), random), kPeriod, options);
    for (int k = 2; k <= 80; ++k) {
      filter.predict(kPeriod, options);
      filter.correct(k < 40 ? noisy(x(k * kPeriod), random) : seen(x(k * kPeriod)), options);
      ASSERT_TRUE(filter.position().allFinite() && filter.covariance().allFinite());
      ASSERT_EQ(filter.covariance().llt().info(), Eigen::Success);
    }
    EXPECT_FALSE(filter.walks());
    EXPECT_LE(filter.velocity().norm(), 0.01);  // nothing but 4 s of exact positions at a stand
  }
}

// Turning round in place is the worst for a heading: in the sweep after it the velocity is wrong by 2.4
// m/s, with no sd below 0.1 m/s: 24^2. A covariance singular across the path of who stops would say
// thousands.
TEST(HeadingFilter, IsNeverSureOfTheWrongVelocity) {
  const HeadingOptions options = plain();
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    const double away = random.uniform(-3.1, 3.1);
    const auto velocity = [&](double t) { return Vector2(1.2 * direction(t < 2.0 ? 0.0 : away)); };
    Vector2 position(0.0, 0.0);
    const SeenPosition first = noisy(position, random);
    position += kPeriod * velocity(0.0);
    HeadingFilter filter(first, noisy(position, random), kPeriod, options);
    for (int k = 2; k <= 60; ++k) {
      position += kPeriod * velocity((k - 1) * kPeriod);
      filter.predict(kPeriod, options);
      filter.correct(noisy(position, random), options);
      const Vector2 error = filter.velocity() - velocity((k - 0.5) * kPeriod);
      const Eigen::Matrix2d P = filter.covariance().bottomRightCorner<2, 2>();
      worst = std::max(worst, error.dot(P.ldlt().solve(error)));
    }
  }
  EXPECT_LE(worst, 576.0);
}

// Rotated by any angle, the same walk gives the same result rotated: across the cut at pi, too.
TEST(HeadingFilter, NoHeadingIsSpecial) {
  const auto walk = [&](double angle) {
    Random random(5);
    const Eigen::Matrix2d R = Eigen::Rotation2Dd(angle).toRotationMatrix();
    const auto position = [&](double t) {
      const Vector2 wave(1.0 * t, 0.5 * std::sin(2.0 * t));
      const double x = random.normal(0.0, kNoise);
      return seen(R * (wave + Vector2(x, random.normal(0.0, kNoise))));
    };
    return follow(position, 0.0, 6.0, plain());
  };
  const HeadingFilter straight = walk(0.0);
  for (const double angle : {0.5, 1.7, 2.9, 3.1, 3.14159, -3.0, -1.0}) {
    const Eigen::Matrix2d R = Eigen::Rotation2Dd(angle).toRotationMatrix();
    const HeadingFilter rotated = walk(angle);
    EXPECT_LE((rotated.velocity() - R * straight.velocity()).norm(), 1e-9);
    EXPECT_LE((rotated.position() - R * straight.position()).norm(), 1e-9);
    EXPECT_NEAR(rotated.covariance().trace(), straight.covariance().trace(), 1e-9);
  }
}

}  // namespace
}  // namespace bw::people
