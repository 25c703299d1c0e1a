#include "components/local_planner/carrot.hpp"

#include <gtest/gtest.h>

namespace bw {
namespace {

const std::vector<Pose2> kCorner = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}};

TEST(Carrot, LiesAheadOfTheNearestPointAlongThePlan) {
  // Nearest to (1, 0.5) is (1, 0); 2 m on: (3, 0); 5 m on: round the corner to (4, 2).
  EXPECT_TRUE(carrot(kCorner, {1.0, 0.5}, 2.0).isApprox(Vector2(3.0, 0.0)));
  EXPECT_TRUE(carrot(kCorner, {1.0, 0.5}, 5.0).isApprox(Vector2(4.0, 2.0)));
}

TEST(Carrot, IsTheEndWhenThatIsNearerOrAskedFor) {
  EXPECT_TRUE(carrot(kCorner, {1.0, 0.5}, 50.0).isApprox(Vector2(4.0, 4.0)));
  EXPECT_TRUE(carrot(kCorner, {1.0, 0.5}, 0.0).isApprox(Vector2(4.0, 4.0)));
}

TEST(Carrot, OfDegeneratePlans) {
  EXPECT_TRUE(carrot({{2, 1, 0}}, {0.0, 0.0}, 1.0).isApprox(Vector2(2.0, 1.0)));
  EXPECT_TRUE(carrot({{2, 1, 0}, {2, 1, 0}, {2, 1, 0}}, {0.0, 0.0}, 1.0).isApprox(Vector2(2.0, 1.0)));
}

}  // namespace
}  // namespace bw
