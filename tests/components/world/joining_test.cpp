// People who join a running world, and people who are pushed.
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "components/world/world.hpp"
#include "tests/components/world/hallway.hpp"

namespace bw {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void run(World& world, double seconds) {
  for (int i = 0; i < std::lround(seconds / 0.01); ++i) world.step();
}

const Person& person(const World& world, std::uint32_t id) {
  for (const Person& person : world.people()) {
    if (person.id == id) return person;
  }
  throw std::runtime_error("nobody is " + std::to_string(id));
}

/// An open floor with a wall along x = 8; the robot stands at the origin and is seen by nobody.
WorldOptions floor_with_wall() {
  WorldOptions options;
  options.walls = {{8, -50, 8, 50}};
  options.people_react = false;
  return options;
}

TEST(Joining, IdsGoOnBehindEverybodyElse) {
  World hallway_world(hallway(), {}, {}, 1);  // 2 who stand, 6 who walk
  EXPECT_EQ(hallway_world.add_person({.position = {12, 2}}).id, 9U);
  EXPECT_EQ(hallway_world.add_person({.position = {15, 2}}).id, 10U);
  EXPECT_EQ(hallway_world.people().size(), 10U);

  // Recorded people have the recorded id plus the number of the others, also who comes later.
  WorldOptions options = floor_with_wall();
  options.people.scripted.resize(1);
  options.people.scripted[0].waypoints = {{3, 3}};
  WorldFiles files;
  files.tracks = {{40, {{500.0, {0.0, 0.0}}, {501.0, {1.0, 0.0}}}}};
  World recorded(options, {}, files, 1);
  EXPECT_EQ(recorded.add_person({.position = {5, 5}}).id, 42U);
}

// 6 m at the mean of 1.0 and 1.3 m/s, to within the 0.5 m that count as there.
TEST(Joining, WithAGoalTheyWalkThereAndBack) {
  World world(floor_with_wall(), {}, {}, 1);
  const auto admission = world.add_person({.position = {-3, 4}, .goal = Vector2(3, 4)});
  ASSERT_EQ(admission.refusal, "");
  run(world, 4.0);
  EXPECT_NEAR(person(world, admission.id).velocity.x(), 1.15, 0.01);
  run(world, 3.0);
  EXPECT_LT(person(world, admission.id).velocity.x(), -0.5);

  const auto slow = world.add_person({.position = {-3, -4}, .velocity = {0.0, 0.4}, .goal = Vector2(3, -4)});
  run(world, 4.0);
  EXPECT_NEAR(person(world, slow.id).velocity.norm(), 0.4, 0.01);
  EXPECT_GT(person(world, slow.id).velocity.x(), 0.39);
}

TEST(Joining, WithoutAGoalTheyKeepToTheirVelocity) {
  World world(floor_with_wall(), {}, {}, 1);
  const auto walker = world.add_person({.position = {-4, 3}, .velocity = {0.6, 0.0}});
  const auto stander = world.add_person({.position = {-4, -3}, .radius = 0.2});
  run(world, 5.0);
  EXPECT_NEAR(person(world, walker.id).position.x(), -1.0, 0.03);
  EXPECT_NEAR(person(world, walker.id).position.y(), 3.0, 1e-3);  // the other is far away
  EXPECT_EQ(person(world, stander.id).position, Vector2(-4, -3));
  EXPECT_EQ(person(world, stander.id).radius, 0.2);
  run(world, 20.0);  // the wall holds them back
  EXPECT_LT(person(world, walker.id).position.x(), 7.7);
}

TEST(Joining, IsRefusedWithTheReason) {
  WorldOptions options = floor_with_wall();
  options.people.scripted.resize(1);
  options.people.scripted[0].waypoints = {{3, 3}};
  World world(options, {}, {}, 1);
  const auto refusal = [&](const NewPerson& person) { return world.add_person(person).refusal; };
  const std::string not_finite = "a number of the request is not finite";
  EXPECT_EQ(refusal({.position = {kNan, 0}}), not_finite);
  EXPECT_EQ(refusal({.position = {4, 4}, .velocity = {0, INFINITY}}), not_finite);
  EXPECT_EQ(refusal({.position = {4, 4}, .goal = Vector2(0, kNan)}), not_finite);
  EXPECT_EQ(refusal({.position = {4, 4}, .radius = kNan}), not_finite);
  EXPECT_EQ(refusal({.position = {1e300, 0}}), "places lie within 100000 m of the origin");
  EXPECT_EQ(refusal({.position = {4, 4}, .radius = 2.1}), "a radius is between 0.05 and 2 m");
  EXPECT_EQ(refusal({.position = {4, 4}, .radius = -0.3}), "a radius is between 0.05 and 2 m");
  EXPECT_EQ(refusal({.position = {4, 4}, .velocity = {3.0, 0.1}}), "too fast: people go at 3 m/s at most");
  EXPECT_EQ(refusal({.position = {7.71, 0}}), "the position is nearer to a wall than the radius");
  EXPECT_EQ(refusal({.position = {4, 4}, .goal = Vector2(8, 0)}),
            "the goal is nearer to a wall than the radius");
  EXPECT_EQ(refusal({.position = {0.5, 0}}), "a robot stands there");  // two radii of 0.3 m
  EXPECT_EQ(refusal({.position = {3.5, 3}}), "person 1 stands there");
  EXPECT_EQ(world.people().size(), 1U);
  for (int i = 0; i < 99; ++i) EXPECT_EQ(refusal({.position = {-10.0 - i, 0}}), "") << i;
  EXPECT_EQ(refusal({.position = {4, 4}}), "there are 100 people already, which is the most");
}

// A push of 1 m/s fades with the relaxation time of 0.5 s: 0.5 m in all, and 1 - 1/e of that in the first 0.5
// s. What is below 1 mm/s is cut: half a millimetre.
TEST(Push, MovesWhoStands) {
  WorldOptions options = floor_with_wall();
  options.people.scripted.resize(1);
  options.people.scripted[0].waypoints = {{3, 3}};
  World world(options, {}, {}, 1);
  EXPECT_EQ(world.push_person(1, {0.0, 1.0}), "");
  world.step();
  EXPECT_NEAR(person(world, 1).velocity.y(), std::exp(-0.01 / 0.5), 1e-9);
  run(world, 0.49);
  EXPECT_NEAR(person(world, 1).position.y(), 3.0 + 0.5 * (1.0 - std::exp(-1.0)), 1e-9);
  run(world, 10.0);
  EXPECT_NEAR(person(world, 1).position.y(), 3.5, 6e-4);
  EXPECT_EQ(person(world, 1).position.x(), 3.0);
  EXPECT_EQ(person(world, 1).velocity, Vector2(0.0, 0.0));
}

// Along their path: the walk goes on as it was, 1 m/s times 0.5 s further on.
TEST(Push, MovesAWalkerAlongTheirWay) {
  WorldOptions options = floor_with_wall();
  options.people.social.walkers = {{-40, 3, 40, 3}};
  World pushed(options, {}, {}, 1);
  World left_alone(options, {}, {}, 1);
  run(pushed, 2.0);
  run(left_alone, 2.0);
  EXPECT_EQ(pushed.push_person(1, {1.0, 0.0}), "");
  run(pushed, 8.0);
  run(left_alone, 8.0);
  EXPECT_NEAR(person(pushed, 1).position.x() - person(left_alone, 1).position.x(), 0.5, 6e-4);
  EXPECT_NEAR((person(pushed, 1).velocity - person(left_alone, 1).velocity).norm(), 0.0, 1e-9);
}

// 0.5 m before the wall; the push would move them by 1.25 m.
TEST(Push, EndsAtAWall) {
  WorldOptions options = floor_with_wall();
  options.people.scripted.resize(1);
  options.people.scripted[0].waypoints = {{7.2, 3}};
  World world(options, {}, {}, 1);
  EXPECT_EQ(world.push_person(1, {2.5, 0.0}), "");
  run(world, 5.0);
  EXPECT_LE(person(world, 1).position.x(), 7.7);
  EXPECT_GT(person(world, 1).position.x(), 7.7 - 0.025);  // one step at 2.5 m/s
}

TEST(Push, IsRefusedWithTheReason) {
  WorldOptions options = floor_with_wall();
  options.people.scripted.resize(1);
  options.people.scripted[0].waypoints = {{3, 3}};
  WorldFiles files;
  files.tracks = {{40, {{0.0, {5.0, 5.0}}, {50.0, {5.0, 5.0}}}}};
  World world(options, {}, files, 1);
  EXPECT_EQ(world.push_person(1, {kNan, 0.0}), "a number of the request is not finite");
  EXPECT_EQ(world.push_person(2, {1.0, 0.0}), "there is no person 2");
  EXPECT_EQ(world.push_person(kFirstRobotId, {1.0, 0.0}), "there is no person 2000000000");
  EXPECT_EQ(world.push_person(41, {1.0, 0.0}), "person 41 walks as recorded");
  EXPECT_EQ(world.push_person(1, {3.1, 0.0}), "too fast: people go at 3 m/s at most");
  EXPECT_EQ(world.push_person(1, {2.0, 0.0}), "");
  EXPECT_EQ(world.push_person(1, {2.0, 0.0}), "too fast: people go at 3 m/s at most") << "4 m/s in all";
  EXPECT_EQ(world.push_person(1, {-2.0, 0.0}), "");
  run(world, 5.0);
  EXPECT_EQ(person(world, 1).position, Vector2(3.0, 3.0));
}

}  // namespace
}  // namespace bw
