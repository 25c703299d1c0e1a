#include "components/local_planner/hrvo/cones.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw::hrvo {
namespace {

Vector2 random_vector(Random& random, double size) {
  const double x = random.uniform(-size, size);
  return {x, random.uniform(-size, size)};
}

Neighbour disc(const Vector2& position, const Vector2& velocity, double radius, bool shares) {
  return {{position, position}, radius, velocity, shares, position.norm()};
}

RobotMotion moving(const Vector2& velocity) { return {{0.0, 0.0}, velocity, velocity, 0.0}; }

// Distance of `v` from the line of a leg through `origin`.
double off_line(const Vector2& leg, const Vector2& v, const Vector2& origin) {
  return std::abs(cross(leg, v - origin));
}

TEST(Cones, ApexLiesOnOneLegOfEachObstacle) {
  // hrvo/theory.md 5.3: reciprocal leg on the passing side, leg of the velocity obstacle on the other, to
  // rounding.
  Random random(1);
  double worst = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const double radius = random.uniform(0.4, 1.0);
    const Vector2 p = radius * random.uniform(1.05, 10.0) * direction(random.uniform(-3.2, 3.2));
    const Vector2 robot = random_vector(random, 1.5);
    const Vector2 other = random_vector(random, 1.5);
    const VelocityCone cone = cone_of(disc(p, other, radius, true), moving(robot), {});
    const Vector2 middle = 0.5 * (robot + other);
    const bool pass_left = cross(p, robot - other) > 0.0;
    worst = std::max({worst, off_line(pass_left ? cone.left : cone.right, cone.apex, middle),
                      off_line(pass_left ? cone.right : cone.left, cone.apex, other)});
    EXPECT_NEAR(cross(cone.right, p.normalized()), radius / p.norm(), 1e-12) << "opening angle";
    EXPECT_NEAR(cross(p.normalized(), cone.left), radius / p.norm(), 1e-12);
  }
  EXPECT_LE(worst, 1e-12);
}

TEST(Cones, VelocityTowardsANeighbourIsInside) {
  // A fault of the public library (hrvo/theory.md 5.3): a relative position turned round points the cone
  // away.
  for (const bool shares : {false, true}) {
    const VelocityCone cone = cone_of(disc({3.0, 0.0}, {0.0, 0.0}, 0.8, shares), moving({1.0, 0.0}), {});
    EXPECT_TRUE(is_inside(cone, {1.0, 0.0}, 1e-7));
    EXPECT_FALSE(is_inside(cone, {-1.0, 0.0}, 1e-7));
  }
}

TEST(Cones, PresentVelocityIsInsideExactlyWhenItLeadsToAContact) {
  // True of the velocity obstacle by definition, of the reciprocal one because 2 v - v_A = v for v = v_A.
  Random random(2);
  int contacts = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector2 p = random.uniform(1.1, 6.0) * direction(random.uniform(-3.2, 3.2));
    const Vector2 robot = random_vector(random, 1.0);
    const Vector2 other = random_vector(random, 1.0);
    const Vector2 v = robot - other;
    const double nearest_time = std::max(0.0, p.dot(v) / v.squaredNorm());
    const double miss = (p - nearest_time * v).norm();
    if (std::abs(miss - 1.0) < 1e-6) continue;
    contacts += miss < 1.0 ? 1 : 0;
    for (const bool shares : {false, true}) {
      EXPECT_EQ(is_inside(cone_of(disc(p, other, 1.0, shares), moving(robot), {}), robot, 0.0), miss < 1.0);
    }
  }
  EXPECT_GT(contacts, 200);
}

TEST(Cones, PassingRightMovesTheRightLeg) {
  // Warning (b): det(s1, v), not det(v, s1). sin a = 1/4, s1 = (0.96825, -0.25), det(s1, v) = 0.15318,
  // sin 2a = 0.48412: the apex is 0.15821 along the left leg.
  const VelocityCone cone = cone_of(disc({4.0, 0.0}, {0.0, 0.0}, 1.0, true), moving({1.0, -0.1}), {});
  EXPECT_NEAR(cone.apex.x(), 0.15318, 1e-5);
  EXPECT_NEAR(cone.apex.y(), 0.03955, 1e-5);
}

TEST(Cones, StraightAheadPassesRight) {
  const VelocityCone cone = cone_of(disc({4.0, 0.0}, {-1.0, 0.0}, 1.0, true), moving({1.0, 0.0}), {});
  EXPECT_LT(off_line(cone.right, cone.apex, {0.0, 0.0}), 1e-12) << "reciprocal leg on the right";
  EXPECT_LT(off_line(cone.left, cone.apex, {-1.0, 0.0}), 1e-12);
}

TEST(Cones, PreferredVelocityDecidesTheSideOnRequest) {
  HrvoOptions options;
  options.passing_side = PassingSide::preferred;
  RobotMotion robot = moving({1.0, -0.1});
  robot.preferred = {1.0, 0.1};
  const VelocityCone cone = cone_of(disc({4.0, 0.0}, {0.0, 0.0}, 1.0, true), robot, options);
  EXPECT_LT(off_line(cone.left, cone.apex, 0.5 * robot.velocity), 1e-12) << "reciprocal leg on the left";
}

TEST(Cones, MirroredPairGivesMirroredCone) {
  Random random(3);
  const auto mirror = [](const Vector2& v) { return Vector2(v.x(), -v.y()); };
  for (int i = 0; i < 1000; ++i) {
    const Vector2 p = random.uniform(0.2, 5.0) * direction(random.uniform(-3.2, 3.2));
    const Vector2 robot = random_vector(random, 1.0);
    const Vector2 other = random_vector(random, 1.0);
    const VelocityCone a = cone_of(disc(p, other, 0.8, i % 2 == 0), moving(robot), {});
    const VelocityCone b =
        cone_of(disc(mirror(p), mirror(other), 0.8, i % 2 == 0), moving(mirror(robot)), {});
    EXPECT_LT((mirror(a.apex) - b.apex).norm(), 1e-12);
    EXPECT_LT((mirror(a.right) - b.left).norm(), 1e-12);
    EXPECT_LT((mirror(a.left) - b.right).norm(), 1e-12);
  }
}

TEST(Cones, OverlapGivesAHalfPlane) {
  // 0.3 m too near, 0.25 s: the discs must part at 1.2 m/s, half of it when both do it.
  const RobotMotion robot = moving({1.0, 0.0});
  const VelocityCone shared = cone_of(disc({0.5, 0.0}, {-1.0, 0.0}, 0.8, true), robot, {});
  EXPECT_NEAR(shared.apex.x(), 0.0 - 0.6, 1e-12);
  const VelocityCone alone = cone_of(disc({0.5, 0.0}, {-1.0, 0.0}, 0.8, false), robot, {});
  EXPECT_NEAR(alone.apex.x(), -1.0 - 1.2, 1e-12);
  EXPECT_TRUE(is_inside(alone, {-2.1, 5.0}, 0.0));
  EXPECT_FALSE(is_inside(alone, {-2.3, 5.0}, 0.0));
}

TEST(Cones, OnlyANeighbourThatSharesGetsAReciprocalCone) {
  // D7. Both move at 1 m/s towards each other: the velocity obstacle starts at the other's velocity.
  const RobotMotion robot = moving({1.0, 0.0});
  EXPECT_EQ(cone_of(disc({4.0, 0.0}, {-1.0, 0.0}, 1.0, false), robot, {}).apex, Vector2(-1.0, 0.0));
  // v / 2 = (1, 0) = k (s1 + s2), k = 0.5 / cos a; apex = v_B + k s2 with tan a = 1 / sqrt(15).
  const Vector2 shared = cone_of(disc({4.0, 0.0}, {-1.0, 0.0}, 1.0, true), robot, {}).apex;
  EXPECT_NEAR(shared.x(), -0.5, 1e-12);
  EXPECT_NEAR(shared.y(), 0.5 / std::sqrt(15.0), 1e-12);
}

TEST(Cones, SensingMarginMovesBothLegsOutByIt) {
  HrvoOptions options;
  options.sensing_margin = 0.07;
  const Neighbour n = disc({2.0, 1.0}, {-0.3, 0.2}, 0.9, false);
  const VelocityCone cone = cone_of(n, moving({1.0, 0.0}), options);
  EXPECT_NEAR(off_line(cone.left, n.velocity, cone.apex), 0.07, 1e-12);
  EXPECT_NEAR(off_line(cone.right, n.velocity, cone.apex), 0.07, 1e-12);
}

TEST(Cones, TouchingAndCoincidentDiscsStayFinite) {
  for (const double distance : {0.0, 1e-300, 1e-9, 1.0 - 1e-15, 1.0, 1.0 + 1e-15, 1.0 + 1e-9, 1.0 + 1e-6}) {
    for (const bool shares : {false, true}) {
      const VelocityCone cone = cone_of(disc({distance, 0.0}, {0.3, 0.4}, 1.0, shares), moving({1, 0}), {});
      EXPECT_TRUE(cone.apex.allFinite() && cone.right.allFinite() && cone.left.allFinite()) << distance;
      EXPECT_TRUE(is_inside(cone, {1.0, 0.0}, 0.0)) << distance << ": towards it at 0.7 m/s";
    }
  }
}

}  // namespace
}  // namespace bw::hrvo
