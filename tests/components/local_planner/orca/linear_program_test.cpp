// Against a search of all velocities on a grid, which knows nothing of linear programs.
#include "components/local_planner/orca/linear_program.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw::orca {
namespace {

constexpr int kSeeds = 400;
constexpr double kGrid = 0.01;  // [m/s]

struct Program {
  std::vector<HalfPlane> half_planes;
  Vector2 wanted{0.0, 0.0};
  double v_max = 1.0;
};

// `reach`: how far from standing the lines pass at most; below 0 standing lies outside.
HalfPlane random_line(Random& random, double nearest, double reach) {
  const double angle = random.uniform(-M_PI, M_PI);
  const Vector2 along = direction(angle);
  const Vector2 inward{-along.y(), along.x()};
  return {-random.uniform(nearest, reach) * inward, along};
}

Program random_program(Random& random, int lines, double nearest, double reach) {
  Program program;
  program.v_max = random.uniform(0.5, 1.5);
  for (int i = 0; i < lines; ++i) program.half_planes.push_back(random_line(random, nearest, reach));
  const double x = random.uniform(-1.5, 1.5);
  const double y = random.uniform(-1.5, 1.5);
  program.wanted = {x, y};
  return program;
}

double greatest_violation(const Program& program, std::size_t from, std::size_t to, const Vector2& v) {
  double greatest = -1e9;
  for (std::size_t i = from; i < to; ++i) greatest = std::max(greatest, violation(program.half_planes[i], v));
  return greatest;
}

// The least of `figure` over the grid's velocities that fulfil `allowed`.
template <class Figure, class Allowed>
std::optional<double> least(double v_max, const Figure& figure, const Allowed& allowed) {
  std::optional<double> least;
  const int n = static_cast<int>(v_max / kGrid) + 1;
  for (int i = -n; i <= n; ++i) {
    for (int j = -n; j <= n; ++j) {
      const Vector2 v(i * kGrid, j * kGrid);
      if (v.norm() > v_max || !allowed(v)) continue;
      if (!least || figure(v) < *least) least = figure(v);
    }
  }
  return least;
}

TEST(LinearProgram, ClosedForms) {
  // Nothing in the way: the wish, cut to the circle.
  EXPECT_EQ(best_velocity({}, 0, {0.3, 0.4}, 1.0).velocity, Vector2(0.3, 0.4));
  EXPECT_TRUE(best_velocity({}, 0, {3.0, 4.0}, 1.0).velocity.isApprox(Vector2(0.6, 0.8)));
  // At most 0.5 to the east: the foot on the line.
  const HalfPlane east{{0.5, 0.0}, {0.0, 1.0}};
  EXPECT_TRUE(best_velocity({east}, 0, {0.9, 0.2}, 1.0).velocity.isApprox(Vector2(0.5, 0.2)));
  // And at most 0.1 to the north: the corner.
  const HalfPlane north{{0.0, 0.1}, {-1.0, 0.0}};
  EXPECT_TRUE(best_velocity({east, north}, 0, {0.9, 0.2}, 1.0).velocity.isApprox(Vector2(0.5, 0.1)));
  // At least 0.4 to the west and to the east at once: in the middle both are violated by 0.4.
  const HalfPlane must_west{{-0.4, 0.0}, {0.0, 1.0}}, must_east{{0.4, 0.0}, {0.0, -1.0}};
  const Choice torn = best_velocity({must_west, must_east}, 0, {0.0, 0.2}, 1.0);
  EXPECT_FALSE(torn.free);
  EXPECT_NEAR(torn.velocity.x(), 0.0, 1e-9);
  // A wall is not violated for it.
  const Choice at_wall = best_velocity({must_west, must_east}, 1, {0.0, 0.2}, 1.0);
  EXPECT_FALSE(at_wall.free);
  EXPECT_NEAR(at_wall.velocity.x(), -0.4, 1e-9);
}

TEST(LinearProgram, IsTheNearestOfAGrid) {
  int free = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Program p = random_program(random, 1 + seed % 8, -0.2, 1.2);
    const std::size_t n = p.half_planes.size();
    const Choice choice = best_velocity(p.half_planes, 0, p.wanted, p.v_max);
    ASSERT_LE(choice.velocity.norm(), p.v_max + 1e-9) << "seed " << seed;
    const auto nearest = least(
        p.v_max, [&](const Vector2& v) { return (v - p.wanted).norm(); },
        [&](const Vector2& v) { return greatest_violation(p, 0, n, v) <= 0.0; });
    if (!choice.free) {
      EXPECT_FALSE(nearest) << "seed " << seed << ": the grid has a velocity within all";
      continue;
    }
    ++free;
    EXPECT_LE(greatest_violation(p, 0, n, choice.velocity), 1e-6) << "seed " << seed;
    if (nearest) {
      EXPECT_LE((choice.velocity - p.wanted).norm(), *nearest + 1e-9) << "seed " << seed;
    }
  }
  EXPECT_GT(free, kSeeds / 2);
}

TEST(LinearProgram, WithoutAWayTheGreatestViolationIsTheLeastOfAGrid) {
  int torn = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    Program p = random_program(random, 3 + seed % 6, -1.0, 0.3);
    // Walls that allow standing come first.
    const auto walls = static_cast<std::size_t>(seed % 3);
    for (std::size_t i = 0; i < walls; ++i) p.half_planes[i] = random_line(random, 0.05, 0.8);
    const std::size_t n = p.half_planes.size();
    const Choice choice = best_velocity(p.half_planes, walls, p.wanted, p.v_max);
    ASSERT_LE(choice.velocity.norm(), p.v_max + 1e-9) << "seed " << seed;
    if (walls > 0) {
      EXPECT_LE(greatest_violation(p, 0, walls, choice.velocity), 1e-6) << "seed " << seed;
    }
    if (choice.free) continue;
    ++torn;
    const auto least_bad = least(
        p.v_max, [&](const Vector2& v) { return greatest_violation(p, walls, n, v); },
        [&](const Vector2& v) { return walls == 0 || greatest_violation(p, 0, walls, v) <= 0.0; });
    ASSERT_TRUE(least_bad) << "seed " << seed;
    EXPECT_LE(greatest_violation(p, walls, n, choice.velocity), *least_bad + 1e-6) << "seed " << seed;
  }
  EXPECT_GT(torn, kSeeds / 2);
}

}  // namespace
}  // namespace bw::orca
