#include "components/ideal_people/velocity_memory.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace bw {
namespace {

Mover walker(std::uint32_t id, double vx, double vy) { return {.id = id, .velocity = {vx, vy}}; }

TEST(VelocityMemory, ForgetsAnOldVelocityAsAnExponential) {
  VelocityMemory memory;
  std::vector<Mover> people{walker(1, 1.0, 0.0)};
  memory.smooth(people, 0.5, 0.1);
  EXPECT_EQ(people[0].velocity, Vector2(1.0, 0.0));  // nothing is known before
  for (int k = 1; k <= 10; ++k) {
    people = {walker(1, 0.0, 2.0)};
    memory.smooth(people, 0.5, 0.1);
    const double old = std::exp(-0.1 * k / 0.5);
    EXPECT_NEAR(people[0].velocity.x(), old, 1e-12);
    EXPECT_NEAR(people[0].velocity.y(), 2.0 * (1.0 - old), 1e-12);
  }
}

TEST(VelocityMemory, WhoWasAwayComesAsNew) {
  VelocityMemory memory;
  std::vector<Mover> people{walker(1, 1.0, 0.0), walker(2, 0.5, 0.0)};
  memory.smooth(people, 0.5, 0.1);
  people = {walker(2, 0.5, 0.0)};
  memory.smooth(people, 0.5, 0.1);
  people = {walker(1, 0.0, 1.0)};
  memory.smooth(people, 0.5, 0.1);
  EXPECT_EQ(people[0].velocity, Vector2(0.0, 1.0));
}

TEST(VelocityMemory, AClockThatGoesBackBeginsAnew) {
  VelocityMemory memory;
  std::vector<Mover> people{walker(1, 1.0, 0.0)};
  memory.smooth(people, 0.5, 0.1);
  people = {walker(1, 0.0, 1.0)};
  memory.smooth(people, 0.5, -100.0);
  EXPECT_EQ(people[0].velocity, Vector2(0.0, 1.0));
}

TEST(VelocityMemory, NoneLeavesVelocitiesAsTheyAre) {
  VelocityMemory memory;
  std::vector<Mover> people{walker(1, 1.0, 0.0)};
  memory.smooth(people, 0.0, 0.1);
  people = {walker(1, 0.0, 1.0)};
  memory.smooth(people, 0.0, 0.1);
  EXPECT_EQ(people[0].velocity, Vector2(0.0, 1.0));
}

}  // namespace
}  // namespace bw
