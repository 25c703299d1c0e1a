#include "components/world/orca_walkers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "components/world/world.hpp"

namespace bw {
namespace {

const StaticScene kBareFloor({}, {});

// BANDWAGON_CROSSINGS sets how many.
int crossings() {
  const char* asked = std::getenv("BANDWAGON_CROSSINGS");
  return asked ? std::atoi(asked) : 40;
}

std::vector<Person> after(OrcaWalkers& walkers, double seconds, std::span<const RobotBody> robots = {}) {
  constexpr double kStep = 0.01;
  const std::vector<Person> nobody;
  std::vector<Person> now;
  for (int i = 0; i < static_cast<int>(std::lround(seconds / kStep)); ++i) {
    now.clear();
    walkers.step(kStep, {nobody, robots}, now);
  }
  return now;
}

double least_gap(const std::vector<Person>& people) {
  double gap = 1e9;
  for (std::size_t i = 0; i < people.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      gap = std::min(gap,
                     (people[i].position - people[j].position).norm() - people[i].radius - people[j].radius);
  }
  return gap;
}

// Ten people from all sides of a crossing of 10 m, each to the opposite side.
OrcaWalkersOptions crossing(Random& random) {
  OrcaWalkersOptions options;
  options.turn_round = false;
  for (int i = 0; i < 10; ++i) {
    const Vector2 start =
        random.uniform(4.8, 5.2) * direction(2.0 * M_PI * i / 10.0 + random.uniform(-0.2, 0.2));
    const Vector2 goal = -start;
    options.walkers.push_back({start.x(), start.y(), goal.x(), goal.y()});
  }
  return options;
}

TEST(OrcaWalkers, WalkStraightAtTheirSpeedWhereNobodyIs) {
  OrcaWalkersOptions options;
  options.walkers = {{0.0, 0.0, 10.0, 0.0}};
  options.speed_min = options.speed_max = 1.2;
  OrcaWalkers walkers(options, kBareFloor, 1, Random(1));
  const auto now = after(walkers, 2.0);
  EXPECT_NEAR((now[0].position - Vector2(2.4, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_LT(after(walkers, 9.0)[0].velocity.x(), -1.0) << "turned round";
  options.turn_round = false;
  OrcaWalkers once(options, kBareFloor, 1, Random(1));
  EXPECT_EQ(after(once, 15.0)[0].velocity, Vector2(0.0, 0.0));
  EXPECT_LE((after(once, 1.0)[0].position - Vector2(10.0, 0.0)).norm(), 0.5);
}

TEST(OrcaWalkers, DoNotTouchInAnOpenCrossing) {
  int arrived = 0;
  for (int seed = 1; seed <= crossings(); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const OrcaWalkersOptions options = crossing(random);
    OrcaWalkers walkers(options, kBareFloor, 1, Random(random.bits()));
    std::vector<Person> now;
    double gap = 1e9;
    for (int i = 0; i < 3000; ++i) {
      now = after(walkers, 0.01);
      gap = std::min(gap, least_gap(now));
    }
    EXPECT_GE(gap, 0.0) << "seed " << seed;
    for (std::size_t i = 0; i < now.size(); ++i)
      arrived +=
          (now[i].position - Vector2(options.walkers[i].goal_x, options.walkers[i].goal_y)).norm() <= 0.6;
  }
  std::printf("%d of %d arrived within 30 s\n", arrived, 10 * crossings());
  EXPECT_GE(arrived, 9 * crossings());
}

TEST(OrcaWalkers, AreTheSameForTheSameSeed) {
  Random random(3);
  const OrcaWalkersOptions options = crossing(random);
  OrcaWalkers one(options, kBareFloor, 1, Random(7)), same(options, kBareFloor, 1, Random(7));
  OrcaWalkers other(options, kBareFloor, 1, Random(8));
  bool differs = false;
  for (int i = 0; i < 100; ++i) {
    const auto a = after(one, 0.1), b = after(same, 0.1), c = after(other, 0.1);
    for (std::size_t k = 0; k < a.size(); ++k) {
      ASSERT_EQ(a[k].position, b[k].position);
      differs |= a[k].position != c[k].position;
    }
  }
  EXPECT_TRUE(differs) << "speeds come from the seed";
}

TEST(OrcaWalkers, GiveWayToTheRobotOnlyIfTheySeeIt) {
  const RobotBody robot{{5.0, 0.05}, {0.0, 0.0}, 0.3};
  const auto nearest_pass = [&](std::span<const RobotBody> seen) {
    OrcaWalkersOptions options;
    options.walkers = {{0.0, 0.0, 10.0, 0.0}};
    options.robots_share = false;
    OrcaWalkers walkers(options, kBareFloor, 1, Random(1));
    double nearest = 5.0;
    for (int i = 0; i < 1000; ++i)
      nearest = std::min(nearest, (after(walkers, 0.01, seen)[0].position - robot.position).norm());
    return nearest;
  };
  EXPECT_LT(nearest_pass({}), 0.06);
  EXPECT_GE(nearest_pass({&robot, 1}), 0.6);
}

// 2 m wide, five each way: nobody is pushed into the walls.
TEST(OrcaWalkers, KeepOffWalls) {
  StaticObstacles walls;
  walls.segments = {{{-20.0, 1.0}, {20.0, 1.0}}, {{-20.0, -1.0}, {20.0, -1.0}}};
  walls.discs = {{{0.0, 0.9}, 0.2}};
  OccupancyGrid map;
  map.resolution = 0.1;
  map.origin = {6.0, -1.0};
  map.width = map.height = 2;
  map.cells.assign(4, OccupancyGrid::kOccupied);
  const StaticScene corridor(walls, map);
  OrcaWalkersOptions options;
  for (int i = 0; i < 5; ++i) {
    const double y = 0.2 * (i - 2);
    options.walkers.push_back({-12.0 - 1.5 * i, y, 12.0, y});
    options.walkers.push_back({12.0 + 1.5 * i, -y, -12.0, -y});
  }
  OrcaWalkers walkers(options, corridor, 1, Random(1));
  double gap = 1e9, wall_gap = 1e9;
  for (int i = 0; i < 4000; ++i) {
    const auto now = after(walkers, 0.01);
    gap = std::min(gap, least_gap(now));
    for (const Person& p : now) wall_gap = std::min(wall_gap, corridor.clearance(p.position, 1.0) - p.radius);
  }
  EXPECT_GE(wall_gap, -0.01);
  EXPECT_GE(gap, -0.05);
}

// Ids: scripted ones from 1, then social walkers, then these.
TEST(OrcaWalkers, JoinAWorldBehindTheOthersAndSeeTheRobotIfPeopleReact) {
  WorldOptions options;
  options.people.scripted.resize(1);
  options.people.scripted[0].waypoints = {{30.0, 30.0}};
  options.people.social.walkers = {{-30.0, 30.0, -20.0, 30.0}};
  options.people.orca.walkers = {{5.0, 0.05, -5.0, 0.05}};
  options.people.orca.robots_share = false;
  for (const bool react : {false, true}) {
    options.people_react = react;
    World world(options, {}, {}, 1);
    ASSERT_EQ(world.people().size(), 3u);
    EXPECT_EQ(world.people()[2].id, 3u);
    EXPECT_EQ(world.push_person(3, {0.1, 0.0}), "");
    for (int i = 0; i < 900; ++i) world.step();
    EXPECT_EQ(world.contacts().count(ContactKind::person) > 0, !react);
  }
}

}  // namespace
}  // namespace bw
