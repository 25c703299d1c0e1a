#include "components/ideal_people/ideal_tracks.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace bw {
namespace {

Mover walker(std::uint32_t id, double x, double y, double vx, double vy) {
  return {.id = id, .position = {x, y}, .velocity = {vx, vy}, .radius = 0.25};
}

TEST(IdealTracks, WithoutNoiseAreTheTruthAndItsStraightFuture) {
  Random random(1);
  const auto tracks = ideal_tracks({walker(7, 1.0, 2.0, 0.5, -1.0)}, {0.0, 0.0}, {}, random);
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].id, 7U);
  EXPECT_EQ(tracks[0].position, Vector2(1.0, 2.0));
  EXPECT_EQ(tracks[0].radius, 0.25);
  ASSERT_EQ(tracks[0].predictions.size(), 8U);  // 4 s in steps of 0.5 s
  EXPECT_NEAR(tracks[0].predictions.back().time, 4.0, 1e-12);
  EXPECT_NEAR((tracks[0].predictions.back().position - Vector2(3.0, -2.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((tracks[0].position_at(6.0) - Vector2(4.0, -4.0)).norm(), 0.0, 1e-12);
  // (0.2 * 16 / 2)^2 = 2.56 m^2 after 4 s.
  EXPECT_NEAR(tracks[0].predictions.back().covariance(0, 0), 2.56, 1e-12);
  EXPECT_EQ(tracks[0].predictions.back().covariance(0, 1), 0.0);
}

TEST(IdealTracks, OnlyPeopleInRangeAndSoundOnesAreSeen) {
  Random random(1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto tracks = ideal_tracks(
      {walker(1, 14.9, 0, 0, 0), walker(2, 15.1, 0, 0, 0), walker(3, nan, 0, 0, 0)}, {0.0, 0.0}, {}, random);
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].id, 1U);
}

TEST(IdealTracks, NoiseHasTheStandardDeviationAskedFor) {
  constexpr std::uint64_t kSeed = 9;
  Random random(kSeed);
  IdealPeopleOptions options;
  options.position_noise = 0.05;
  options.velocity_noise = 0.1;
  constexpr int kDraws = 20'000;
  double position_sum = 0.0;
  double velocity_sum = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const auto tracks = ideal_tracks({walker(1, 1.0, 0.0, 1.0, 0.0)}, {0.0, 0.0}, options, random);
    position_sum += (tracks[0].position - Vector2(1.0, 0.0)).squaredNorm() / 2.0;
    velocity_sum += (tracks[0].velocity - Vector2(1.0, 0.0)).squaredNorm() / 2.0;
  }
  // The sample deviation of 40,000 values scatters by 1 / sqrt(80,000) = 0.35 %; 3 of them.
  EXPECT_NEAR(std::sqrt(position_sum / kDraws) / 0.05, 1.0, 0.011) << "seed " << kSeed;
  EXPECT_NEAR(std::sqrt(velocity_sum / kDraws) / 0.1, 1.0, 0.011) << "seed " << kSeed;
}

TEST(IdealTracks, NoiseOfOnePersonDoesNotDependOnWhoElseIsInRange) {
  IdealPeopleOptions options;
  options.position_noise = 0.1;
  Random a(4);
  Random b(4);
  const auto with = ideal_tracks({walker(1, 2, 0, 0, 0), walker(2, 3, 0, 0, 0)}, {0.0, 0.0}, options, a);
  const auto without = ideal_tracks({walker(1, 200, 0, 0, 0), walker(2, 3, 0, 0, 0)}, {0.0, 0.0}, options, b);
  EXPECT_EQ(with[1].position, without[0].position);
}

TEST(IdealTracks, ZeroHorizonMeansNoPredictions) {
  Random random(1);
  IdealPeopleOptions options;
  options.prediction_horizon = 0.0;
  EXPECT_TRUE(ideal_tracks({walker(1, 2, 0, 1, 0)}, {0.0, 0.0}, options, random)[0].predictions.empty());
}

}  // namespace
}  // namespace bw
