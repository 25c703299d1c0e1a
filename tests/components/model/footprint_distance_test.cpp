#include "components/model/footprint_distance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw {
namespace {

constexpr std::uint64_t kSeed = 71;

TEST(FootprintDistance, OfAPointToPointDiscAndSegment) {
  EXPECT_DOUBLE_EQ(distance_to(Vector2(3, 4), {{0, 0}, {0, 0}, 0.0}).distance, 5.0);
  EXPECT_DOUBLE_EQ(distance_to(Vector2(3, 4), {{0, 0}, {0, 0}, 2.0}).distance, 3.0);
  EXPECT_DOUBLE_EQ(distance_to(Vector2(0.3, 2), {{-1, 0}, {1, 0}, 0.5}).distance, 1.5);
  EXPECT_DOUBLE_EQ(distance_to(Vector2(4, 4), {{-1, 0}, {1, 0}, 0.0}).distance, 5.0);
  EXPECT_EQ(distance_to(Vector2(0, 0), {{0, 0}, {0, 0}, 0.0}).gradient, Vector2(0.0, 0.0));
}

Footprint random_polygon(Random& random) {
  const double a = random.uniform(0.1, 0.6), b = random.uniform(0.1, 0.6), front = random.uniform(0.0, 0.3);
  Footprint footprint{.radius = std::hypot(a + front, b),
                      .polygon = {{-a, -b}, {a, -b}, {a + front, 0.0}, {a, b}, {-a, b}}};
  if (random.uniform() < 0.5) std::ranges::reverse(footprint.polygon);
  return footprint;
}

struct Case {
  Footprint footprint;
  Pose2 pose;
  Capsule capsule;
};

Case random_case(Random& random) {
  Case c{.footprint = random_polygon(random),
         .pose = {random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0), random.uniform(-3.1, 3.1)},
         .capsule = {}};
  const auto position_of = [&] {
    const double x = random.uniform(-1.2, 1.2);
    return c.pose * Vector2(x, random.uniform(-1.2, 1.2));
  };
  c.capsule.a = position_of();
  c.capsule.b = random.uniform() < 0.4 ? c.capsule.a : position_of();
  c.capsule.radius = random.uniform(0.0, 0.3);
  return c;
}

// Outside: the least of all distances between points of the outline and of the segment, 400 on each edge.
double sampled_distance(const Case& c) {
  double nearest = INFINITY;
  const std::vector<Vector2>& corners = c.footprint.polygon;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (int k = 0; k < 400; ++k) {
      const Vector2 point = corners[i] + (corners[(i + 1) % corners.size()] - corners[i]) * (k / 400.0);
      nearest = std::min(nearest, distance_to(Vector2(c.pose * point), c.capsule).distance);
    }
  }
  return nearest;
}

TEST(FootprintDistance, OutsideIsThatOfTheNearestPoints) {
  Random random(kSeed);
  int outside = 0;
  for (int i = 0; i < 3000; ++i) {
    const Case c = random_case(random);
    const double gap = gap_to(c.footprint, c.pose, c.capsule);
    if (gap + c.capsule.radius <= 0.0) continue;
    ++outside;
    // An edge of 1.2 m has a sample at least every 3 mm.
    EXPECT_NEAR(gap, sampled_distance(c), 0.002) << "seed " << kSeed << " case " << i;
  }
  EXPECT_GT(outside, 1000);
}

// Who moves by the depth along the gradient, or a little more, is free; by a little less in whichever
// direction, not.
TEST(FootprintDistance, InsideIsHowFarTheRobotMustMove) {
  Random random(kSeed + 1);
  int inside = 0;
  for (int i = 0; i < 6000; ++i) {
    Case c = random_case(random);
    c.capsule.radius = 0.0;
    const FootprintDistance found = distance_to(c.footprint, c.pose, c.capsule);
    if (found.distance >= -1e-6) continue;
    ++inside;
    const auto gap_after = [&](const Vector2& motion) {
      return gap_to(c.footprint, {c.pose.x + motion.x(), c.pose.y + motion.y(), c.pose.theta}, c.capsule);
    };
    EXPECT_NEAR(found.gradient.norm(), 1.0, 1e-9);
    EXPECT_NEAR(gap_after(-found.distance * found.gradient), 0.0, 1e-9)
        << "seed " << kSeed + 1 << " case " << i;
    for (int k = 0; k < 36; ++k) {
      const Vector2 away = direction(2.0 * std::numbers::pi * k / 36.0);
      EXPECT_LT(gap_after(-0.99 * found.distance * away), 0.0)
          << "seed " << kSeed + 1 << " case " << i << " way " << k;
    }
  }
  EXPECT_GT(inside, 1000);
}

// Central differences of 1e-6: their error is below 1e-6 but where the nearest pair changes, which is rare.
TEST(FootprintDistance, DerivativesAreThoseOfTheDistance) {
  Random random(kSeed + 2);
  constexpr double kStep = 1e-6;
  int off = 0;
  for (int i = 0; i < 10000; ++i) {
    const Case c = random_case(random);
    const FootprintDistance found = distance_to(c.footprint, c.pose, c.capsule);
    const auto slope = [&](double Pose2::*variable) {
      Pose2 before = c.pose, after = c.pose;
      before.*variable -= kStep;
      after.*variable += kStep;
      return (gap_to(c.footprint, after, c.capsule) - gap_to(c.footprint, before, c.capsule)) / (2.0 * kStep);
    };
    const double worst = std::max({std::abs(found.gradient.x() - slope(&Pose2::x)),
                                   std::abs(found.gradient.y() - slope(&Pose2::y)),
                                   std::abs(found.by_theta - slope(&Pose2::theta))});
    if (worst > 1e-5) ++off;
  }
  EXPECT_LE(off, 3) << "seed " << kSeed + 2;
}

TEST(FootprintDistance, EnoughAsksForNoMore) {
  Random random(kSeed + 3);
  for (int i = 0; i < 3000; ++i) {
    const Case c = random_case(random);
    const double exact = gap_to(c.footprint, c.pose, c.capsule);
    const double enough = random.uniform(-0.5, 1.0);
    const double found = gap_to(c.footprint, c.pose, c.capsule, enough);
    if (exact < enough) {
      EXPECT_EQ(found, exact) << i;
    } else {
      EXPECT_GE(found, enough) << i;
    }
  }
}

TEST(Footprint, HoldsADiscOfTheDistanceToItsNearestEdge) {
  EXPECT_DOUBLE_EQ(inscribed_radius({.radius = 0.3}), 0.3);
  const Footprint rectangle{.radius = 0.34,
                            .polygon = {{-0.2, -0.215}, {0.3, -0.215}, {0.3, 0.215}, {-0.2, 0.215}}};
  EXPECT_NEAR(inscribed_radius(rectangle), 0.2, 1e-12);
  const Footprint ahead{.radius = 0.9, .polygon = {{0.1, -0.2}, {0.8, -0.2}, {0.8, 0.2}, {0.1, 0.2}}};
  EXPECT_EQ(inscribed_radius(ahead), 0.0);
}

}  // namespace
}  // namespace bw
