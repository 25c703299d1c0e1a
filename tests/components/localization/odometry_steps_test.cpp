#include "components/localization/odometry_steps.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "components/localization/source_names.hpp"

namespace bw::localization {
namespace {

/// Covariance of (distance, rotation) of the last of two steps of 0.1 m straight on: k 0.1 / 2 of the
/// distance.
double distance_variance(OdometrySteps steps, double heading_variance) {
  EXPECT_FALSE(steps.add(Time::seconds(1.0), {}, 0.0));
  const std::optional<WheelStep> step = steps.add(Time::seconds(1.1), {0.1, 0.0, 0.0}, heading_variance);
  EXPECT_TRUE(step);
  EXPECT_NEAR(step->distance, 0.1, 1e-15);
  EXPECT_EQ(step->source, 3);
  return step->covariance(0, 0);
}

// Both wheels went 0.1 m: the heading's variance grows by 0.2 k / 0.4^2.
TEST(OdometrySteps, TheNoiseIsTheOdometrysOwnUnlessItIsGiven) {
  const double declared = 2e-4;
  const double growth = 0.2 * declared / 0.16;
  EXPECT_NEAR(distance_variance({3, 0.4, 0.0}, growth), declared * 0.1 / 2.0, 1e-15);
  EXPECT_NEAR(distance_variance({3, 0.4, 1e-3}, growth), 1e-3 * 0.1 / 2.0, 1e-15);
  EXPECT_NEAR(distance_variance({3, 0.4, 0.0}, 0.0), 5e-4 * 0.1 / 2.0, 1e-15);
}

// Eddie's counts are 2 pi 0.0762 / 144 = 3.325 mm apart, its wheels 0.39 m: sqrt(1 / 6) 3.325 / 390 = 3.48
// mrad.
TEST(OdometrySteps, AStepSaysHowCoarselyItsTurnWasCounted) {
  OdometrySteps steps(0, 0.39, 0.0, 0.003325);
  EXPECT_FALSE(steps.add(Time::seconds(1.0), {}, 0.0));
  const std::optional<WheelStep> standing = steps.add(Time::seconds(1.1), {}, 0.0);
  ASSERT_TRUE(standing);
  EXPECT_NEAR(std::sqrt(standing->rounding), 3.48e-3, 1e-5);
  EXPECT_EQ(standing->covariance(1, 1), 0.0);
}

TEST(OdometrySteps, AClockThatWentBackGivesNoStep) {
  OdometrySteps steps(0, 0.4, 0.0);
  EXPECT_FALSE(steps.add(Time::seconds(2.0), {}, 0.0));
  EXPECT_FALSE(steps.add(Time::seconds(1.0), {0.1, 0.0, 0.0}, 0.0));
  EXPECT_TRUE(steps.add(Time::seconds(1.1), {0.2, 0.0, 0.0}, 0.0));
}

TEST(SourceNames, AreNumberedFromZeroWithoutALimit) {
  SourceNames names;
  for (int i = 0; i < 20; ++i) EXPECT_EQ(names.add("sensor" + std::to_string(i)), i);
  EXPECT_EQ(names.count(), 20);
  EXPECT_EQ(names.of(19), "sensor19");
  EXPECT_EQ(names.of(20), "unknown");
  EXPECT_EQ(names.of(-1), "unknown");
}

}  // namespace
}  // namespace bw::localization
