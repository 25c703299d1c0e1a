#include "components/local_planner/hrvo/hrvo.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw::hrvo {
namespace {

constexpr double kGoalX = 6.0;

PlanningProblem random_scene(Random& random) {
  const auto anywhere = [&] {
    const double x = random.uniform(-4.0, 5.0);
    return Vector2(x, random.uniform(-4.0, 4.0));
  };
  PlanningProblem problem;
  problem.twist.v = random.uniform(0.0, 1.0);
  problem.pose.theta = random.uniform(-1.0, 1.0);
  for (int i = 0; i < 4; ++i) {
    Mover m;
    m.position = anywhere();
    m.velocity = 0.3 * anywhere();
    m.reciprocal = i % 2 == 0;
    problem.movers.push_back(m);
    problem.obstacles.points.push_back(anywhere());
    problem.obstacles.discs.push_back({anywhere(), 0.25});
  }
  problem.obstacles.segments = {{anywhere(), anywhere()}};
  return problem;
}

// Everything in the scene but its limits, through `map`.
template <class Map>
PlanningProblem transformed(PlanningProblem problem, const Map& map) {
  const Vector2 ahead = map(problem.pose.position() + direction(problem.pose.theta));
  const Vector2 origin = map(problem.pose.position());
  problem.pose = {origin.x(), origin.y(), std::atan2(ahead.y() - origin.y(), ahead.x() - origin.x())};
  const Vector2 zero = map({0.0, 0.0});
  for (Mover& m : problem.movers) {
    m.position = map(m.position);
    m.velocity = map(m.velocity) - zero;
  }
  for (Vector2& p : problem.obstacles.points) p = map(p);
  for (Disc& d : problem.obstacles.discs) d.center = map(d.center);
  for (Segment& s : problem.obstacles.segments) s = {map(s.a), map(s.b)};
  return problem;
}

TEST(Hrvo, TurnsAndMovesWithTheScene) {
  Random random(6);
  for (int i = 0; i < 300; ++i) {
    const PlanningProblem problem = random_scene(random);
    const Pose2 X{random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0), random.uniform(-3.1, 3.1)};
    const auto map = [&](const Vector2& p) { return X * p; };
    const Advice here = advise(problem, {kGoalX, 0.0}, {});
    const Advice there = advise(transformed(problem, map), map({kGoalX, 0.0}), {});
    EXPECT_EQ(here.free, there.free) << i;
    EXPECT_LT((rotate(X, here.velocity) - there.velocity).norm(), 1e-6) << i;
  }
}

TEST(Hrvo, MirroredSceneGivesMirroredVelocity) {
  Random random(7);
  const auto mirror = [](const Vector2& p) { return Vector2(p.x(), -p.y()); };
  for (int i = 0; i < 300; ++i) {
    const PlanningProblem problem = random_scene(random);
    const Advice left = advise(problem, {kGoalX, 0.3}, {});
    const Advice right = advise(transformed(problem, mirror), {kGoalX, -0.3}, {});
    EXPECT_LT((mirror(left.velocity) - right.velocity).norm(), 1e-6) << i;
  }
}

TEST(Hrvo, OrderOfTheSceneDoesNotMatter) {
  Random random(8);
  for (int i = 0; i < 100; ++i) {
    const PlanningProblem problem = random_scene(random);
    PlanningProblem reversed = problem;
    std::reverse(reversed.movers.begin(), reversed.movers.end());
    std::reverse(reversed.obstacles.points.begin(), reversed.obstacles.points.end());
    std::reverse(reversed.obstacles.discs.begin(), reversed.obstacles.discs.end());
    EXPECT_EQ(advise(problem, {kGoalX, 0.0}, {}).velocity, advise(reversed, {kGoalX, 0.0}, {}).velocity) << i;
  }
}

TEST(Hrvo, PreferredVelocitySlowsDownBeforeTheGoal) {
  PlanningProblem problem;
  problem.limits.v_max = 1.0;
  problem.limits.acc_max = 0.5;
  EXPECT_NEAR(advise(problem, {5.0, 0.0}, {}).preferred.x(), 1.0, 1e-12);
  EXPECT_NEAR(advise(problem, {0.0, 0.25}, {}).preferred.y(), 0.5, 1e-12) << "sqrt(2 0.5 0.25)";
  EXPECT_NEAR(advise(problem, {0.02, 0.0}, {}).preferred.x(), 0.08, 1e-12) << "0.02 m / 0.25 s";
  EXPECT_EQ(advise(problem, {0.0, 0.0}, {}).preferred, Vector2(0.0, 0.0));
  problem.goal_is_final = false;
  EXPECT_NEAR(advise(problem, {0.0, 0.25}, {}).preferred.y(), 1.0, 1e-12) << "the journey goes on";
}

TEST(Hrvo, TwoThatShareTheWayPassOnTheSameSide) {
  // Head-on at 1 m/s each: both to their right, each half of what one alone would have to do.
  PlanningProblem problem;
  problem.twist.v = 1.0;
  Mover other;
  other.position = {5.0, 0.0};
  other.velocity = {-1.0, 0.0};
  problem.movers = {other};
  const Vector2 alone = advise(problem, {kGoalX, 0.0}, {}).velocity;
  problem.movers[0].reciprocal = true;
  const Vector2 shared = advise(problem, {kGoalX, 0.0}, {}).velocity;
  EXPECT_LT(shared.y(), 0.0);
  EXPECT_NEAR(shared.y(), 0.5 * alone.y(), 1e-9);
}

TEST(Hrvo, FiniteAndWithinVmaxWhateverTheScene) {
  Random random(9);
  for (int i = 0; i < 3000; ++i) {
    PlanningProblem problem = random_scene(random);
    const double scale = std::pow(10.0, random.uniform(-12.0, 5.0));
    for (Mover& m : problem.movers) m.position *= scale;
    for (Disc& d : problem.obstacles.discs) d = {d.center * scale, i % 3 == 0 ? 0.0 : d.radius};
    problem.movers[0].position = problem.pose.position();
    problem.movers[1].velocity *= scale;
    problem.obstacles.segments[0].b = problem.obstacles.segments[0].a;
    if (i % 2 == 0) problem.footprint.radius = 0.0;
    HrvoOptions options;
    options.margin = i % 4 < 2 ? 0.0 : 0.2;
    options.reciprocity = i % 5 == 0 ? Reciprocity::all : Reciprocity::known;
    const Advice advice = advise(problem, {scale, 0.0}, options);
    ASSERT_TRUE(advice.velocity.allFinite()) << i;
    ASSERT_LE(advice.velocity.norm(), problem.limits.v_max) << i;
    for (const VelocityCone& cone : advice.cones) ASSERT_TRUE(cone.apex.allFinite()) << i;
  }
}

}  // namespace
}  // namespace bw::hrvo
