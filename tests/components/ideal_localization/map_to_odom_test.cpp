#include "components/ideal_localization/map_to_odom.hpp"

#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw {
namespace {

TEST(MapToOdom, OdometryThroughItFallsOnTheTruth) {
  constexpr std::uint64_t kSeed = 5;
  Random random(kSeed);
  for (int i = 0; i < 1000; ++i) {
    const Pose2 X_MB{random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-3, 3)};
    const Pose2 X_OB{random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-3, 3)};
    const Pose2 X = map_to_odom(X_MB, {}, 0.0, X_OB) * X_OB;
    EXPECT_NEAR(X.x, X_MB.x, 1e-9) << "seed " << kSeed;
    EXPECT_NEAR(X.y, X_MB.y, 1e-9);
    EXPECT_NEAR(wrap_angle(X.theta - X_MB.theta), 0.0, 1e-12);
  }
}

TEST(MapToOdom, ALaterOdometryMeetsTheTruthCarriedAlongItsArc) {
  // Perfect odometry from the map's origin: odom is map, whatever the delay between the two messages.
  const Twist2 twist{0.8, 0.6};
  const Pose2 X_MB = advance_exact({}, twist, 2.0);
  for (const double ahead : {-0.1, 0.0, 0.02, 0.1}) {
    const Pose2 X_MO = map_to_odom(X_MB, twist, ahead, advance_exact({}, twist, 2.0 + ahead));
    EXPECT_NEAR(X_MO.x, 0.0, 1e-12);
    EXPECT_NEAR(X_MO.y, 0.0, 1e-12);
    EXPECT_NEAR(X_MO.theta, 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace bw
