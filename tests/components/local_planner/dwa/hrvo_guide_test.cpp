#include "components/local_planner/dwa/hrvo_guide.hpp"

#include <gtest/gtest.h>

#include "tests/components/local_planner/planner_drive.hpp"

namespace bw::dwa {
namespace {

PlanningProblem with_mover(const Vector2& position, const Vector2& velocity) {
  PlanningProblem problem = problem_to({16, 0, 0});
  Mover mover;
  mover.position = position;
  mover.velocity = velocity;
  problem.movers = {mover};
  return problem;
}

TEST(SomebodyWithin, IsWhoCouldBeMet) {
  // Robot and person 0.3 m each, v_max 1 m/s, 3 s: who comes at 1 m/s counts up to 6.6 m, who walks away at 1
  // m/s up to 0.6 m, who crosses at 0.5 m/s up to where sqrt(d^2 + 1.5^2) is 3.6 m, and who stands never.
  EXPECT_TRUE(somebody_within(with_mover({3.2, 0}, {0, 0.5}), 3.0));
  EXPECT_FALSE(somebody_within(with_mover({3.3, 0}, {0, 0.5}), 3.0));
  EXPECT_FALSE(somebody_within(with_mover({1.0, 0}, {0, 0.1}), 3.0));
  EXPECT_TRUE(somebody_within(with_mover({-6.5, 0}, {1, 0}), 3.0)) << "from behind as well";
  EXPECT_FALSE(somebody_within(with_mover({6.7, 0}, {-1, 0}), 3.0));
  EXPECT_TRUE(somebody_within(with_mover({0.5, 0}, {1, 0}), 3.0));
  EXPECT_FALSE(somebody_within(with_mover({0.7, 0}, {1, 0}), 3.0));
  EXPECT_FALSE(somebody_within(problem_to({16, 0, 0}), 3.0));
}

TEST(SomebodyWithin, IsNobodyWhoIsNotConfirmed) {
  PlanningProblem problem = with_mover({1, 0}, {0, 1});
  EXPECT_TRUE(somebody_within(problem, 3.0));
  problem.movers[0].confidence = 0.45;
  EXPECT_FALSE(somebody_within(problem, 3.0));
}

TEST(HrvoGuide, CostsWhatASampleDiffersFromTheAdvice) {
  // HRVO says 0.5 m/s to the left by 0.4 rad. Rotating at 0.1 rad/s for 1 s leaves 0.3 rad; 0.8 m/s is 0.3
  // m/s too fast.
  hrvo::Advice advice;
  advice.velocity = 0.5 * direction(0.4);
  EdwaOptions options;
  options.heading_scale = 10.0;
  options.advised_speed_scale = 100.0;
  const HrvoGuide guide(problem_to({16, 0, 0}), advice, options);
  EXPECT_TRUE(guide.has_direction());
  EXPECT_NEAR(guide.cost({.twist = {0.8, 0.1}}), 3.0 + 30.0, 1e-9);
  options.hrvo_speed = false;
  EXPECT_NEAR(HrvoGuide(problem_to({16, 0, 0}), advice, options).cost({.twist = {0.8, 0.1}}), 3.0, 1e-9);
  advice.velocity = {0.01, 0.0};
  EXPECT_FALSE(HrvoGuide(problem_to({16, 0, 0}), advice, options).has_direction());
}

}  // namespace
}  // namespace bw::dwa
