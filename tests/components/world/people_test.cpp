// Scripted, social and recorded people: closed forms and symmetries.
#include <cmath>

#include <gtest/gtest.h>

#include "components/world/replayed_people.hpp"
#include "components/world/scripted_people.hpp"
#include "components/world/social_walkers.hpp"

namespace bw {
namespace {

const std::vector<Person> kNobody;
const StaticScene kPeoplesFloor({}, std::nullopt);

std::vector<Person> after(PeopleModel& model, double seconds, std::span<const RobotBody> robots = {}) {
  std::vector<Person> people;
  for (int i = 0; i < std::lround(seconds / 0.01); ++i) {
    people.clear();
    model.step(0.01, {kNobody, robots}, people);
  }
  return people;
}

TEST(ScriptedPeople, WalkTheirWaypointsAndBack) {
  ScriptedPersonOptions script;
  script.waypoints = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}};  // 7 m
  script.speed = 2.0;
  script.start_time = 1.0;
  script.turn_round = true;
  ScriptedPeople people({script}, 11);
  auto now = after(people, 0.5);
  ASSERT_EQ(now.size(), 1u);
  EXPECT_EQ(now[0].id, 11u);
  EXPECT_EQ(now[0].position, Vector2(0.0, 0.0));
  EXPECT_EQ(now[0].velocity, Vector2(0.0, 0.0));
  now = after(people, 1.5);  // t = 2: 2 m along
  EXPECT_NEAR((now[0].position - Vector2(2.0, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((now[0].velocity - Vector2(2.0, 0.0)).norm(), 0.0, 1e-9);
  now = after(people, 1.5);  // t = 3.5: 5 m along
  EXPECT_NEAR((now[0].position - Vector2(4.0, 1.0)).norm(), 0.0, 1e-9);
  now = after(people, 1.5);  // t = 5: 8 m walked, 1 m back from the end
  EXPECT_NEAR((now[0].position - Vector2(4.0, 2.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((now[0].velocity - Vector2(0.0, -2.0)).norm(), 0.0, 1e-9);
  now = after(people, 3.5);  // t = 8.5: 15 m walked, 1 m into the second round
  EXPECT_NEAR((now[0].position - Vector2(1.0, 0.0)).norm(), 0.0, 1e-9);
}

TEST(ScriptedPeople, StandAtTheEndOrAllTheTime) {
  ScriptedPersonOptions walker;
  walker.waypoints = {{0.0, 0.0}, {1.0, 0.0}};
  ScriptedPersonOptions stander;
  stander.waypoints = {{9.0, -1.6}};
  ScriptedPeople people({walker, stander}, 1);
  const auto now = after(people, 5.0);
  EXPECT_EQ(now[0].position, Vector2(1.0, 0.0));
  EXPECT_EQ(now[0].velocity, Vector2(0.0, 0.0));
  EXPECT_EQ(now[1].position, Vector2(9.0, -1.6));
  EXPECT_EQ(now[1].id, 2u);
  EXPECT_THROW(ScriptedPeople({ScriptedPersonOptions{}}, 1), std::runtime_error);
}

TEST(SocialForce, HeadOnHasItsClosedForm) {
  // Both at 1 m/s, 2 m apart: D = 2 * 2 + 1 = 5, B = 1.75, q = 0: slowing and sideways (to the right) 2.1
  // exp(-2 / 1.75).
  const SocialForceOptions options;
  const Vector2 on_left = social_force(options, {2.0, 0.0}, {2.0, 0.0});
  const double strength = 2.1 * std::exp(-2.0 / 1.75);
  EXPECT_NEAR(on_left.x(), -strength, 1e-12);
  EXPECT_NEAR(on_left.y(), -strength, 1e-12);
  // The other one meets the same force rotated by half a turn: both pass on their right.
  const Vector2 on_right = social_force(options, {-2.0, 0.0}, {-2.0, 0.0});
  EXPECT_NEAR((on_left + on_right).norm(), 0.0, 1e-12);
}

TEST(SocialForce, MirrorsWithTheScene) {
  const SocialForceOptions options;
  const Vector2 left = social_force(options, {1.5, 0.4}, {1.0, 0.2});
  const Vector2 right = social_force(options, {1.5, -0.4}, {1.0, -0.2});
  EXPECT_NEAR(left.x(), right.x(), 1e-12);
  EXPECT_NEAR(left.y(), -right.y(), 1e-12);
  EXPECT_LT(left.y(), 0.0) << "somebody to the left pushes to the right";
}

TEST(SocialForce, IsZeroWhereThereIsNoDirection) {
  EXPECT_EQ(social_force({}, {0.0, 0.0}, {1.0, 0.0}), Vector2(0.0, 0.0));
  EXPECT_EQ(social_force({}, {1.0, 0.0}, {-0.5, 0.0}), Vector2(0.0, 0.0));  // D = 2 (-0.5) + 1 = 0
  EXPECT_EQ(obstacle_force({}, {0.0, 0.0}, 0.3), Vector2(0.0, 0.0));
}

// Two of a group 1.4 m apart are 0.7 m from their middle, beyond the half metre of a pair; 0.8 m apart they are not drawn.
TEST(SocialForce, DrawsWhoIsLeftBehindToTheGroup) {
  const SocialForceOptions options;
  EXPECT_TRUE(group_force(options, {0.7, 0.0}, 2).isApprox(Vector2(3.0, 0.0), 1e-12));
  EXPECT_EQ(group_force(options, {0.4, 0.0}, 2), Vector2(0.0, 0.0));
  EXPECT_EQ(group_force(options, {0.7, 0.0}, 3), Vector2(0.0, 0.0)) << "of three a metre";
}

// Two who start 4 m apart, the same way at the same speed: alone they stay so, as a group they come together.
TEST(SocialWalkers, KeepTogetherInAGroup) {
  SocialWalkersOptions options;
  options.speed_min = options.speed_max = 1.0;
  for (const int group : {0, 1}) {
    options.walkers = {{0.0, 0.0, 100.0, 0.0, group}, {0.0, 4.0, 100.0, 4.0, group}};
    SocialWalkers people(options, kPeoplesFloor, 1, Random(1));
    const std::vector<Person> now = after(people, 20.0);
    const double apart = (now[1].position - now[0].position).norm();
    if (group == 0)
      EXPECT_GE(apart, 3.9);
    else
      EXPECT_LE(apart, 1.5);
    EXPECT_GT(now[0].position.x(), 15.0);
  }
}

TEST(SocialForce, WallPushesByItsSigma) {
  const SocialForceOptions options;  // 10 exp(-(d - r) / 0.8)
  EXPECT_NEAR(obstacle_force(options, {0.0, 0.3}, 0.3).y(), 10.0, 1e-12);
  EXPECT_NEAR(obstacle_force(options, {0.0, -1.1}, 0.3).y(), -10.0 / std::exp(1.0), 1e-12);
}

SocialWalkersOptions one_walker() {
  SocialWalkersOptions options;
  options.walkers = {{0.0, 0.0, 10.0, 0.0}};
  options.speed_min = options.speed_max = 1.2;
  return options;
}

TEST(SocialWalkers, SpeedUpWithTheRelaxationTime) {
  // Alone, v' = (v0 - v) / tau by steps of dt: v_n = v0 (1 - (1 - dt / tau)^n).
  SocialWalkers walkers(one_walker(), kPeoplesFloor, 1, Random(1));
  const auto now = after(walkers, 0.5);
  EXPECT_NEAR(now[0].velocity.x(), 1.2 * (1.0 - std::pow(1.0 - 0.01 / 0.5, 50)), 1e-9);
  EXPECT_NEAR(now[0].velocity.y(), 0.0, 1e-12);
}

TEST(SocialWalkers, TurnRoundAtTheGoalOrStand) {
  SocialWalkersOptions options = one_walker();
  SocialWalkers to_and_fro(options, kPeoplesFloor, 1, Random(1));
  EXPECT_LT(after(to_and_fro, 12.0)[0].velocity.x(), -1.0);
  EXPECT_GT(after(to_and_fro, 9.0)[0].velocity.x(), 1.0);
  options.turn_round = false;
  SocialWalkers once(options, kPeoplesFloor, 1, Random(1));
  const auto now = after(once, 15.0);
  EXPECT_NEAR((now[0].position - Vector2(10.0, 0.0)).norm(), 0.0, 0.75);
  EXPECT_NEAR(now[0].velocity.norm(), 0.0, 1e-3);
}

TEST(SocialWalkers, TwoHeadOnPassSymmetrically) {
  SocialWalkersOptions options;
  options.walkers = {{0.0, 0.0, 12.0, 0.0}, {12.0, 0.0, 0.0, 0.0}};
  options.speed_min = options.speed_max = 1.2;
  options.turn_round = false;
  options.forces.social_factor = 5.1;  // the ROS simulator's value; with 2.1 shoulders brush (0.48 m)
  SocialWalkers walkers(options, kPeoplesFloor, 1, Random(1));
  double nearest = 12.0;
  bool on_the_right = true;
  std::vector<Person> now;
  for (int i = 0; i < 1500; ++i) {
    now = after(walkers, 0.01);
    nearest = std::min(nearest, (now[0].position - now[1].position).norm());
    if (now[0].position.x() > 5.5 && now[0].position.x() < 6.5)
      on_the_right = on_the_right && now[0].position.y() < -0.25;
    // The scene is its own image under half a turn about (6, 0), and stays so.
    ASSERT_NEAR((now[0].position + now[1].position - Vector2(12.0, 0.0)).norm(), 0.0, 1e-6);
  }
  EXPECT_GT(nearest, 0.6) << "two radii";
  EXPECT_TRUE(on_the_right);
  EXPECT_GT(now[0].position.x(), 11.0);
}

TEST(SocialWalkers, GiveWayToTheRobotOnlyIfTheySeeIt) {
  const RobotBody robot{{5.0, 0.0}, {0.0, 0.0}, 0.3};
  const auto nearest_pass = [&](std::span<const RobotBody> seen) {
    SocialWalkersOptions options = one_walker();
    options.forces.social_factor = 5.1;
    SocialWalkers walkers(options, kPeoplesFloor, 1, Random(1));
    double nearest = 5.0;
    for (int i = 0; i < 800; ++i) {
      nearest = std::min(nearest, (after(walkers, 0.01, seen)[0].position - robot.position).norm());
    }
    return nearest;
  };
  EXPECT_LT(nearest_pass({}), 0.01);
  EXPECT_GT(nearest_pass({&robot, 1}), 0.6);
}

TEST(ReplayedPeople, MoveLinearlyBetweenSamplesAndOnlyThen) {
  ReplayOptions options;
  options.start_time = 100.0;
  options.duration = 2.0;
  options.x = 10.0;
  options.theta = 1.5707963267948966;  // recording x becomes map y
  const Track track{7, {{100.4, {0.0, 0.0}}, {100.8, {0.4, 0.0}}, {101.2, {0.4, 0.8}}}};
  const Track beyond{8, {{100.0, {5.0, 5.0}}, {105.0, {5.0, 5.0}}}};
  const Track once{9, {{100.5, {5.0, 5.0}}}};
  ReplayedPeople people(options, {track, beyond, once}, 20);
  auto now = after(people, 0.3);
  ASSERT_EQ(now.size(), 1u);
  EXPECT_EQ(now[0].id, 28u);
  now = after(people, 0.2);  // recorded 100.5: a quarter of the first stretch
  ASSERT_EQ(now.size(), 2u);
  EXPECT_EQ(now[0].id, 27u);
  EXPECT_NEAR((now[0].position - Vector2(10.0, 0.1)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((now[0].velocity - Vector2(0.0, 1.0)).norm(), 0.0, 1e-9);
  now = after(people, 0.6);  // recorded 101.1: three quarters of the second
  EXPECT_NEAR((now[0].position - Vector2(9.4, 0.4)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((now[0].velocity - Vector2(-2.0, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_EQ(after(people, 0.2).size(), 1u);  // recorded 101.3: gone
  EXPECT_TRUE(after(people, 1.0).empty()) << "the window of 2 s is over";
}

}  // namespace
}  // namespace bw
