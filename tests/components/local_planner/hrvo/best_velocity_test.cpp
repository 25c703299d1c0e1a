#include "components/local_planner/hrvo/best_velocity.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "components/local_planner/hrvo/cones.hpp"
#include "components/local_planner/hrvo/hrvo.hpp"
#include "components/model/random.hpp"

namespace bw::hrvo {
namespace {

bool is_free(const std::vector<VelocityCone>& cones, const Vector2& v, double tolerance) {
  return std::none_of(cones.begin(), cones.end(),
                      [&](const VelocityCone& cone) { return is_inside(cone, v, tolerance); });
}

PlanningProblem crowd(Random& random, int count) {
  PlanningProblem problem;
  problem.twist.v = random.uniform(-0.2, 1.0);
  problem.pose.theta = random.uniform(-3.1, 3.1);
  for (int i = 0; i < count; ++i) {
    Mover m;
    m.position = random.uniform(0.4, 4.0) * direction(random.uniform(-3.2, 3.2));
    m.velocity = random.uniform(0.0, 1.3) * direction(random.uniform(-3.2, 3.2));
    m.reciprocal = random.uniform() < 0.5;
    problem.movers.push_back(m);
  }
  return problem;
}

TEST(BestVelocity, NeverWorseThanAGrid) {
  // hrvo/theory.md 5.3: grid of 0.005 m/s, 400 scenes of 1 to 5 neighbours. Only the part of the grid that is
  // nearer to the wish than the answer by more than 0.001 can prove it wrong: all of it must lie in cones.
  constexpr double kStep = 0.005;
  Random random(5);
  int crowded = 0, none_free = 0;
  for (int scene = 0; scene < 400; ++scene) {
    const PlanningProblem problem = crowd(random, 1 + scene % 5);
    const Advice advice = advise(problem, 5.0 * direction(random.uniform(-3.2, 3.2)), {});
    const double answer = (advice.velocity - advice.preferred).norm();
    EXPECT_LE(advice.velocity.norm(), problem.limits.v_max);
    EXPECT_TRUE(!advice.free || is_free(advice.cones, advice.velocity, 2e-7));
    crowded += answer > 0.3 ? 1 : 0;
    none_free += advice.free ? 0 : 1;
    for (double x = -1.0; x <= 1.0; x += kStep) {
      for (double y = -1.0; y <= 1.0; y += kStep) {
        const Vector2 v(x, y);
        if (v.norm() > problem.limits.v_max) continue;
        if (advice.free && (v - advice.preferred).norm() >= answer - 0.001) continue;
        ASSERT_FALSE(is_free(advice.cones, v, 1e-7)) << "scene " << scene << " at " << x << ", " << y;
      }
    }
  }
  EXPECT_GT(crowded, 40) << "the scenes must ask something";
  EXPECT_GT(none_free, 0);
}

TEST(BestVelocity, TheWishItselfWhenFreeAndNoFasterThanAllowed) {
  EXPECT_EQ(best_velocity({}, {0.3, 0.2}, 1.0).velocity, Vector2(0.3, 0.2));
  const BestVelocity clipped = best_velocity({}, {3.0, 4.0}, 1.0);
  EXPECT_NEAR(clipped.velocity.x(), 0.6, 1e-15);
  EXPECT_NEAR(clipped.velocity.y(), 0.8, 1e-15);
}

TEST(BestVelocity, ProjectsOnTheNearerLeg) {
  // Legs at -30 and +60 degrees from the wish: 1 m/s cos 30 along the right one.
  const VelocityCone cone{{0.0, 0.0}, direction(-M_PI / 6.0), direction(M_PI / 3.0)};
  const BestVelocity best = best_velocity({cone}, {1.0, 0.0}, 1.0);
  EXPECT_TRUE(best.free);
  EXPECT_LT((best.velocity - std::cos(M_PI / 6.0) * direction(-M_PI / 6.0)).norm(), 1e-12);
}

TEST(BestVelocity, OfTwoEquallyNearTheRight) {
  const VelocityCone cone{{0.0, 0.0}, direction(-0.3), direction(0.3)};
  EXPECT_LT(best_velocity({cone}, {1.0, 0.0}, 1.0).velocity.y(), 0.0);
  EXPECT_LT(best_velocity({cone}, {-0.5, 0.0}, 1.0).velocity.x(), 0.0) << "outside: untouched";
}

TEST(BestVelocity, AFavouredWayRoundMayCostItsAllowance) {
  // Right leg: sin 0.3 = 0.296 from the wish; left leg: sin 0.35 = 0.343, 0.047 further.
  const VelocityCone cone{{0.0, 0.0}, direction(-0.3), direction(0.35)};
  const Vector2 left(0.9, 0.3);
  const Vector2 wish(1.0, 0.0);
  EXPECT_LT(best_velocity({cone}, wish, 1.0).velocity.y(), 0.0);
  EXPECT_LT(best_velocity({cone}, wish, 1.0, PreviousVelocity{left, 0.04}).velocity.y(), 0.0);
  EXPECT_GT(best_velocity({cone}, wish, 1.0, PreviousVelocity{left, 0.06}).velocity.y(), 0.0);
  EXPECT_EQ(best_velocity({}, wish, 1.0, PreviousVelocity{left, 0.06}).velocity, wish);
}

TEST(BestVelocity, OfNothingFreeWhatMeetsTheFarthestFirst) {
  // Two half planes that leave nothing: v_x must be below -2 (nearer one) and above 2 (farther one). With
  // 1 m/s no leg is reachable; the wish violates the nearer one first, as everything does.
  const auto facing = [](double x, double sign) {
    return VelocityCone{{sign * x, 0.0}, {0.0, -sign}, {0.0, sign}};
  };
  const BestVelocity lost = best_velocity({facing(-2.0, 1.0), facing(-2.0, -1.0)}, {0.5, 0.0}, 1.0);
  EXPECT_FALSE(lost.free);
  EXPECT_EQ(lost.velocity, Vector2(0.5, 0.0));
  // The nearer one can be kept at -0.6 m/s: its leg, at the cost of the farther one.
  const BestVelocity best = best_velocity({facing(-0.6, 1.0), facing(-2.0, -1.0)}, {0.5, 0.0}, 1.0);
  EXPECT_FALSE(best.free);
  EXPECT_NEAR(best.velocity.x(), -0.6, 1e-12);
}

TEST(BestVelocity, DegenerateConesGiveFiniteVelocities) {
  const VelocityCone line{{0.1, 0.0}, {1.0, 0.0}, {1.0, 0.0}};
  const VelocityCone far{{1e9, -1e9}, {0.0, 1.0}, direction(2.0)};
  const VelocityCone plane{{0.2, 0.0}, {0.0, -1.0}, {0.0, 1.0}};
  for (const Vector2& wish : {Vector2(0.0, 0.0), Vector2(0.2, 0.0), Vector2(1.0, 0.0)}) {
    const BestVelocity best = best_velocity({line, line, far, plane, plane}, wish, 1.0);
    EXPECT_TRUE(best.velocity.allFinite());
    EXPECT_LE(best.velocity.x(), 0.2 + 1e-7);
    EXPECT_TRUE(best.free);
  }
}

}  // namespace
}  // namespace bw::hrvo
