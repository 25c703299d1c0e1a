#include "components/local_planner/orca/half_plane.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "components/model/nearest_point.hpp"
#include "components/model/random.hpp"

namespace bw::orca {
namespace {

constexpr std::uint64_t kSeed = 7;

Vector2 random_vector(Random& random, double reach) {
  const double x = random.uniform(-reach, reach);
  const double y = random.uniform(-reach, reach);
  return {x, y};
}

Vector2 inward(const HalfPlane& h) { return {-h.direction.y(), h.direction.x()}; }

// The gap at the closest moment of `horizon` seconds at a constant velocity relative to a segment (a == b: a
// point), by looking at many moments.
double least_gap(const Segment& core, double radius, const Vector2& relative, double horizon) {
  double gap = 1e9;
  for (int i = 0; i <= 2000; ++i) {
    const Vector2 at = i * horizon / 2000.0 * relative;
    gap = std::min(gap, (nearest_point(core, at) - at).norm() - radius);
  }
  return gap;
}

// Two discs of 0.5 m together, 4 m apart, each at 1 m/s towards the other, 2 s ahead. Relative velocity 2:
// inside the cone beyond the disc of radius 0.25 around (2, 0), whose tangents are nearer than its rim:
// asin(0.5 / 4) on each side, so the change is 2 sin = 2 / 8 at right angles to the leg. Each makes half of
// it.
TEST(HalfPlane, OfAHeadOnPairTurnsEachByHalfTheAngleToTheLeg) {
  const Vector2 own{1.0, 0.0};
  const HalfPlane h = clear_of(MovingDisc{{4.0, 0.0}, {-1.0, 0.0}, 0.5}, own, 0.5, 2.0, 0.25);
  EXPECT_NEAR(violation(h, own), 0.125, 1e-12);
  // Straight ahead counts as right: the leg's direction, seen from its end.
  EXPECT_NEAR(h.direction.x(), -std::sqrt(1.0 - 1.0 / 64.0), 1e-12);
  EXPECT_NEAR(h.direction.y(), 0.125, 1e-12);
  EXPECT_NEAR(violation(clear_of(MovingDisc{{4.0, 0.0}, {-1.0, 0.0}, 0.5}, own, 1.0, 2.0, 0.25), own), 0.25,
              1e-12)
      << "alone: all of it";
}

// Standing 4 m before somebody who comes at 0.5 m/s: 4 s ahead the disc of radius 0.125 around 1 m/s lies
// 0.375 m/s ahead of the relative velocity 0.5. Own velocity may rise by half of it.
TEST(HalfPlane, OfSomebodyFarAwayLeavesRoomUpToTheCutOff) {
  const HalfPlane h = clear_of(MovingDisc{{4.0, 0.0}, {-0.5, 0.0}, 0.5}, {0.0, 0.0}, 0.5, 4.0, 0.25);
  EXPECT_NEAR(violation(h, {0.1875, 0.0}), 0.0, 1e-12);
  EXPECT_LT(violation(h, {0.18, 3.0}), 0.0);
  EXPECT_GT(violation(h, {0.19, -3.0}), 0.0);
}

// 0.4 m apart with 0.6 m needed: in a step of 0.25 s the gap must grow by 0.2 m, 0.8 m/s, half of it each.
TEST(HalfPlane, OfAnOverlapEndsItInOneStep) {
  const HalfPlane h = clear_of(MovingDisc{{0.4, 0.0}, {0.0, 0.0}, 0.6}, {0.0, 0.0}, 0.5, 5.0, 0.25);
  EXPECT_NEAR(violation(h, {-0.4, 7.0}), 0.0, 1e-12);
  EXPECT_GT(violation(h, {-0.39, 0.0}), 0.0);
}

// Whoever keeps to both half planes does not touch within the horizon, and whoever is alone with all of the
// change neither.
TEST(HalfPlane, OfDiscsKeepsClearForTheHorizon) {
  Random random(kSeed);
  for (int i = 0; i < 500; ++i) {
    const Vector2 offset = random_vector(random, 4.0);
    const double radius = random.uniform(0.1, 1.0);
    if (offset.norm() < radius + 0.01) continue;
    const Vector2 mine = random_vector(random, 1.5), theirs = random_vector(random, 1.5);
    const double horizon = random.uniform(0.5, 6.0);
    const HalfPlane my_half = clear_of(MovingDisc{offset, theirs, radius}, mine, 0.5, horizon, 0.25);
    const HalfPlane their_half = clear_of(MovingDisc{-offset, mine, radius}, theirs, 0.5, horizon, 0.25);
    const HalfPlane alone = clear_of(MovingDisc{offset, theirs, radius}, mine, 1.0, horizon, 0.25);
    // The worst allowed: on the lines.
    const Vector2 my_next = my_half.point + random.uniform(-1.0, 1.0) * my_half.direction;
    const Vector2 their_next = their_half.point + random.uniform(-1.0, 1.0) * their_half.direction;
    EXPECT_GE(least_gap({offset, offset}, radius, my_next - their_next, horizon), -1e-6)
        << "seed " << kSeed << " " << i;
    const Vector2 alone_next = alone.point + random.uniform(-1.0, 1.0) * alone.direction;
    EXPECT_GE(least_gap({offset, offset}, radius, alone_next - theirs, horizon), -1e-6)
        << "seed " << kSeed << " " << i;
    EXPECT_NEAR(cross(my_half.direction, their_half.direction), 0.0, 1e-9) << "the same change, opposite";
    EXPECT_NEAR((my_half.point - mine + their_half.point - theirs).norm(), 0.0, 1e-9);
  }
}

TEST(HalfPlane, OfWallsKeepsClearForTheHorizonAndAllowsStanding) {
  Random random(kSeed);
  int restricting = 0;
  for (int i = 0; i < 1000; ++i) {
    const Segment wall{random_vector(random, 4.0), random_vector(random, 4.0)};
    const double radius = random.uniform(0.1, 0.8);
    const Vector2 nearest = nearest_point(wall, Vector2(0.0, 0.0));
    const Vector2 own = random_vector(random, 1.5);
    const double horizon = random.uniform(0.5, 6.0);
    const HalfPlane h = clear_of(wall, radius, own, horizon);
    EXPECT_NEAR(h.direction.norm(), 1.0, 1e-9);
    EXPECT_LE(violation(h, {0.0, 0.0}), 1e-9) << "seed " << kSeed << " " << i;
    const Vector2 worst = h.point + random.uniform(-1.0, 1.0) * h.direction;
    if (nearest.norm() <= radius) {
      EXPECT_GE(worst.dot(-nearest), -1e-9) << "does not approach";
      continue;
    }
    EXPECT_GE(least_gap(wall, radius, worst, horizon), -1e-6) << "seed " << kSeed << " " << i;
    // The nearest way out: no velocity nearer to `own` than the line is free, so that nothing is forbidden
    // for nothing.
    const double depth = violation(h, own);
    restricting += depth > 0.0;
    for (int k = 0; depth > 0.0 && k < 32; ++k) {
      const Vector2 near = own + 0.99 * depth * direction(k * M_PI / 16.0);
      EXPECT_LE(least_gap(wall, radius, near, horizon), 1e-2) << "seed " << kSeed << " " << i;
    }
  }
  EXPECT_GT(restricting, 50);
}

// A wall without length is a disc that does not react.
TEST(HalfPlane, OfAWallWithoutLengthIsThatOfADisc) {
  Random random(kSeed);
  for (int i = 0; i < 500; ++i) {
    const Vector2 position = random_vector(random, 3.0);
    const double radius = random.uniform(0.1, 0.8);
    if (position.norm() <= radius) continue;
    const Vector2 own = random_vector(random, 1.5);
    const HalfPlane wall = clear_of(Segment{position, position}, radius, own, 3.0);
    const HalfPlane disc = clear_of(MovingDisc{position, {0.0, 0.0}, radius}, own, 1.0, 3.0, 0.25);
    EXPECT_NEAR((inward(wall) - inward(disc)).norm(), 0.0, 1e-6) << "seed " << kSeed << " " << i;
    EXPECT_NEAR(violation(wall, own), violation(disc, own), 1e-9) << "seed " << kSeed << " " << i;
  }
}

}  // namespace
}  // namespace bw::orca
