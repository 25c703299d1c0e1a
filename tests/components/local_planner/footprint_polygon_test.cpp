// Gaps of polygon footprints against the distance to a rectangle in closed form.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/local_planner/footprint_check.hpp"
#include "components/model/random.hpp"

namespace bw {
namespace {

constexpr std::uint64_t kSeed = 61;

Footprint rectangle(double half_length, double half_width) {
  return {std::hypot(half_length, half_width),
          {{-half_length, -half_width},
           {half_length, -half_width},
           {half_length, half_width},
           {-half_length, half_width}}};
}

// Signed distance of a point in base_link.
double distance_to_rectangle(const Vector2& p, double half_length, double half_width) {
  const Vector2 out(std::abs(p.x()) - half_length, std::abs(p.y()) - half_width);
  return out.cwiseMax(0.0).norm() + std::min(0.0, out.maxCoeff());
}

double gap_to_disc(const Pose2& pose, const Footprint& footprint, const Disc& disc) {
  return gap_at(pose, 0.0, footprint, {.discs = {disc}}, {});
}

TEST(FootprintPolygon, GapIsThatOfTheRectangle) {
  Random random(kSeed);
  int near = 0, inside = 0;
  for (int i = 0; i < 20000; ++i) {
    const double a = random.uniform(0.1, 0.8), b = random.uniform(0.1, 0.8);
    const Footprint footprint = rectangle(a, b);
    const Pose2 pose{random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0), random.uniform(-3.1, 3.1)};
    const double x = random.uniform(-1.5, 1.5), y = random.uniform(-1.5, 1.5);
    const Disc disc{pose * Vector2(x, y), random.uniform(0.0, 0.3)};
    const double expected = distance_to_rectangle({x, y}, a, b) - disc.radius;
    const double gap = gap_to_disc(pose, footprint, disc);
    EXPECT_NEAR(gap, expected, 1e-9) << "seed " << kSeed << " case " << i;
    ++(distance_to_rectangle({x, y}, a, b) > 0.0 ? near : inside);
  }
  EXPECT_GT(near, 2000);
  EXPECT_GT(inside, 1000);
}

TEST(FootprintPolygon, CornersMayRunEitherWayRound) {
  Random random(kSeed);
  Footprint other = rectangle(0.5, 0.3);
  std::reverse(other.polygon.begin(), other.polygon.end());
  for (int i = 0; i < 1000; ++i) {
    const double x = random.uniform(-1.0, 1.0);
    const Disc disc{{x, random.uniform(-1.0, 1.0)}, 0.05};
    EXPECT_NEAR(gap_to_disc({}, rectangle(0.5, 0.3), disc), gap_to_disc({}, other, disc), 1e-12) << i;
  }
}

TEST(FootprintPolygon, WallsAreMetByTheOutlineAndNotByItsDisc) {
  // 1.0 x 0.2 m along x: a wall beside it at y = 0.3 is 0.2 m away, though inside the disc of 0.51 m; rotated
  // by 90 degrees the robot stands in it.
  const Footprint footprint = rectangle(0.5, 0.1);
  const StaticObstacles wall{.segments = {{{-3.0, 0.3}, {3.0, 0.3}}}};
  EXPECT_NEAR(gap_at({0, 0, 0}, 0.0, footprint, wall, {}), 0.2, 1e-12);
  EXPECT_LT(gap_at({0, 0, std::numbers::pi / 2}, 0.0, footprint, wall, {}), 0.0);
  // A wall that ends inside, without crossing any side.
  const StaticObstacles inside{.segments = {{{-0.1, 0.0}, {0.1, 0.0}}}};
  EXPECT_LT(gap_at({0, 0, 0}, 0.0, footprint, inside, {}), 0.0);
}

TEST(FootprintPolygon, NotchesAreFree) {
  // A U open to the front: what stands between its arms is 0.2 m from each of them.
  const Footprint u{0.75,
                    {{-0.5, -0.5},
                     {0.5, -0.5},
                     {0.5, -0.2},
                     {-0.2, -0.2},
                     {-0.2, 0.2},
                     {0.5, 0.2},
                     {0.5, 0.5},
                     {-0.5, 0.5}}};
  EXPECT_NEAR(gap_to_disc({}, u, {{0.2, 0.0}, 0.0}), 0.2, 1e-12);
  EXPECT_LT(gap_to_disc({}, u, {{-0.35, 0.0}, 0.0}), 0.0);
}

TEST(FootprintPolygon, WithoutAreaItIsStillMet) {
  for (const std::vector<Vector2>& polygon : {std::vector<Vector2>{{-0.3, 0.0}, {0.0, 0.0}, {0.3, 0.0}},
                                              std::vector<Vector2>(4, Vector2(0.1, 0.0))}) {
    const double gap = gap_to_disc({}, {0.3, polygon}, {{0.1, 0.1}, 0.0});
    EXPECT_NEAR(gap, 0.1, 1e-12);
  }
}

}  // namespace
}  // namespace bw
