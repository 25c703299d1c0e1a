// Flows and encounters (bench/protocols.md 8.17). Expected numbers are worked out by hand beside them.
#include "components/lab/bench/flows/flow_scenes.hpp"

#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/components/lab/bench/constant_planner.hpp"

namespace bw {
namespace {

using test::ConstantPlanner;

double no_clock() { return 0.0; }

const SceneRobot kRobotFarOff{{-100.0, 0.0}, {0.0, 0.0}};

SceneDrive driven(const DriveScene& scene, LocalPlanner& planner) {
  return drive_scene(scene, ScenePrediction::constant_velocity, planner, no_clock);
}

// 0.2 per square metre of 25 x 4 m are 20 people, of whom a fifth is in groups, side by side 0.8 m apart.
TEST(FlowScene, HasThePeopleOfItsDensity) {
  const DriveScene scene = flow_scene(0.2, 7);
  const std::vector<SceneDisc>& people = scene.movers->discs();
  ASSERT_EQ(people.size(), 20U);
  int grouped = 0;
  for (const SceneDisc& one : people) {
    EXPECT_LE(std::abs(one.position.y()), 1.5);
    EXPECT_GE(one.position.norm(), 1.5) << "of the robot";
    bool in_group = false;
    for (const SceneDisc& other : people) {
      if (&one == &other) continue;
      const Vector2 apart = one.position - other.position;
      EXPECT_GE(apart.norm(), 0.7);
      in_group |= apart.x() == 0.0 && std::abs(std::abs(apart.y()) - 0.8) < 1e-9;
    }
    grouped += in_group ? 1 : 0;
  }
  EXPECT_EQ(grouped, 4);
}

// In a minute at 1.0 to 1.3 m/s everybody goes round the loop of 25 m twice or thrice, as somebody else each time; as many are
// there, between the walls, and on their feet.
TEST(FlowScene, KeepsItsDensity) {
  const auto movers = flow_scene(0.3, 3).movers->clone();
  std::map<std::uint32_t, int> rounds;
  for (const SceneDisc& disc : movers->discs()) rounds[disc.id] = 0;
  double speed = 0.0;
  for (int k = 0; k < 1200; ++k) {
    movers->step(kRobotFarOff);
    std::set<std::uint32_t> ids;
    for (const SceneDisc& disc : movers->discs()) {
      ids.insert(disc.id);
      speed += disc.velocity.norm() / 1200.0 / 30.0;
      EXPECT_LT(std::abs(disc.position.y()), 2.0);
      EXPECT_GE(disc.position.x(), -5.0);
      EXPECT_LE(disc.position.x(), 20.0);
    }
    ASSERT_EQ(ids.size(), 30U);
  }
  for (const SceneDisc& disc : movers->discs()) {
    EXPECT_GE(disc.id / 30, 1U);
    EXPECT_LE(disc.id / 30, 3U);
  }
  EXPECT_GT(speed, 0.9);
}

// Beside a robot that stands where they come in, nobody comes to be within 3 m of it.
TEST(FlowScene, LetsNobodyInBesideTheRobot) {
  const auto movers = flow_scene(0.3, 3).movers->clone();
  const SceneRobot robot{{-4.5, 0.0}, {0.0, 0.0}};
  int came = 0;
  for (int k = 0; k < 1200; ++k) {
    const std::vector<SceneDisc> before = movers->discs();
    movers->step(robot);
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (movers->discs()[i].id == before[i].id) continue;
      ++came;
      EXPECT_GE((movers->discs()[i].position - robot.position).norm(), 3.0);
    }
  }
  EXPECT_GT(came, 10);
}

// How often people touch a robot that stands in their way, of 0.05 and 0.5 per square metre: 2 and 14 times a minute when this was
// written. Who gets through must go out of their way.
TEST(FlowScene, PeopleDoNotKeepOffByThemselves) {
  for (const auto& [density, least, most] : {std::tuple{0.05, 10, 40}, std::tuple{0.5, 90, 200}}) {
    int touches = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const auto movers = flow_scene(density, seed).movers->clone();
      std::set<std::uint32_t> touching;
      for (int k = 0; k < 1200; ++k) {
        movers->step({});
        for (const SceneDisc& disc : movers->discs()) {
          if (disc.position.norm() >= 0.6)
            touching.erase(disc.id);
          else if (touching.insert(disc.id).second)
            ++touches;
        }
      }
    }
    EXPECT_GE(touches, least) << density;
    EXPECT_LE(touches, most) << density;
  }
}

// Somebody waits before the door where the robot is nearer to it, and comes through where it is not.
TEST(DoorScene, PeopleWaitForWhoIsNearer) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const DriveScene scene = door_scene(seed);
    const auto waiting = scene.movers->clone();
    const auto alone = scene.movers->clone();
    for (int k = 0; k < 300; ++k) {
      waiting->step({{3.5, 0.0}, {0.0, 0.0}});
      alone->step(kRobotFarOff);
    }
    EXPECT_GT(waiting->discs()[0].position.x(), 5.0 - 1e-9) << seed << ": the door is at 4 m";
    EXPECT_LT(waiting->discs()[0].position.x(), 5.6 + 1e-9) << seed;
    EXPECT_EQ(waiting->discs()[0].velocity, Vector2(0.0, 0.0));
    EXPECT_LT(alone->discs()[0].position.x(), 3.0) << seed;
  }
}

TEST(CornerScene, SomebodyAppearsNearby) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const auto movers = corner_scene(seed).movers->clone();
    double x = 0.0;
    while (movers->discs()[0].id == 0 && x < 10.0) {
      EXPECT_GT(movers->discs()[0].position.norm(), 50.0);
      movers->step({{x += 0.05, 0.0}, {1.0, 0.0}});
    }
    const SceneDisc& disc = movers->discs()[0];
    const double ahead = disc.position.x() - x;
    EXPECT_GE(ahead, 1.0 - 0.15) << seed << ": 0.05 m of the robot's, 0.07 m of theirs";
    EXPECT_LE(ahead, 2.5 + 0.08) << seed;
    EXPECT_NEAR(std::abs(disc.position.y()), 1.0, 0.08) << "in the mouth";
    for (int k = 0; k < 40; ++k) movers->step(kRobotFarOff);
    EXPECT_LE(std::abs(disc.position.y()), 0.6 + 0.08) << "in the corridor";
    EXPECT_GE(std::abs(disc.position.y()), 0.2 - 0.08) << "nearer to their side";
  }
}

std::vector<double> gaps_of(const DriveScene& scene) {
  std::vector<double> gaps;
  double last = -2.0;
  for (const SceneDisc& disc : scene.movers->discs()) {
    gaps.push_back(disc.position.y() - disc.radius - last);
    last = disc.position.y() + disc.radius;
  }
  gaps.push_back(2.0 - last);
  return gaps;
}

// 4 m less four people of 0.6 m are 1.6 m of gaps: 0.8 m and four of 0.2 m, or five of 0.32 m, and each sways by 0.03 m. The
// robot is 0.6 m wide.
TEST(RowScene, HasOneGapOrNone) {
  std::set<std::size_t> places;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const std::vector<double> open = gaps_of(standing_row_scene(seed));
    ASSERT_EQ(open.size(), 5U);
    for (std::size_t k = 0; k < 5; ++k) {
      if (open[k] > 0.6) places.insert(k);
      EXPECT_NEAR(open[k], open[k] > 0.6 ? 0.8 : 0.2, 0.06 + 1e-9);
    }
    for (const double gap : gaps_of(closed_row_scene(seed))) EXPECT_NEAR(gap, 0.32, 0.06 + 1e-9);
  }
  EXPECT_EQ(places.size(), 5U);
}

// Who stands for 5 s is told that there is no way, which is all that there is to do; in a row with a gap nothing comes of it.
TEST(ClosedRow, IsPassedByStanding) {
  ConstantPlanner standing({0.0, 0.0});
  const SceneDrive told = driven(closed_row_scene(1), standing);
  EXPECT_TRUE(told.success());
  EXPECT_NEAR(told.duration, 5.0, 0.1 + 1e-9);
  EXPECT_FALSE(driven(standing_row_scene(1), standing).passed);
  ConstantPlanner turning({0.2, 0.35});
  EXPECT_FALSE(driven(closed_row_scene(1), turning).passed) << "on a circle of 1.1 m there is progress";
}

// At 0.5 m/s behind somebody as fast: 12.5 m in 25 s.
TEST(OvertakingScene, IsLateForWhoFollows) {
  ConstantPlanner following({0.5, 0.0});
  const SceneDrive drive = driven(overtaking_scene(1), following);
  EXPECT_EQ(drive.contacts, 0);
  EXPECT_FALSE(drive.passed);
}

// From 5 to 9 m at 1.6 m/s at a robot that stands: they are there after 5.6 s at the latest, and go on through it.
TEST(RusherScene, RunsAtTheRobotAndOn) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto movers = rusher_scene(seed).movers->clone();
    double nearest = 100.0;
    for (int k = 0; k < 200; ++k) {
      movers->step({{0.0, 0.5}, {0.0, 0.0}});
      nearest = std::min(nearest, (movers->discs()[0].position - Vector2(0.0, 0.5)).norm());
      EXPECT_NEAR(movers->discs()[0].velocity.norm(), 1.6, 1e-9);
    }
    EXPECT_LT(nearest, 0.09);
    EXPECT_LT(movers->discs()[0].position.x(), -2.0);
  }
}

TEST(ChildScene, RunsAndStopsInTheWay) {
  const auto movers = child_scene(4).movers->clone();
  int stands = 0;
  for (int k = 0; k < 600; ++k) {
    const Vector2 before = movers->discs()[0].position;
    movers->step(kRobotFarOff);
    const SceneDisc& child = movers->discs()[0];
    stands += child.velocity.isZero() ? 1 : 0;
    EXPECT_DOUBLE_EQ(child.radius, 0.2);
    EXPECT_LE((child.position - before).norm(), 1.6 * kSceneStep + 1e-9);
    EXPECT_GE(child.position.x(), 3.0);
    EXPECT_LE(child.position.x(), 8.0);
    EXPECT_LE(std::abs(child.position.y()), 1.5);
  }
  EXPECT_GT(stands, 60);
  EXPECT_LT(stands, 540);
}

// Along an arc into the wall.
TEST(FlowScene, CountsTheWall) {
  DriveScene scene = overtaking_scene(1);
  scene.movers = flow_sets({"G4"}, 1, 1)[0].empty.movers;
  ConstantPlanner turning({1.0, 0.2});
  const SceneDrive drive = driven(scene, turning);
  EXPECT_TRUE(drive.wall);
  EXPECT_EQ(drive.contacts, 1);
}

TEST(FlowSets, AreFoundByTheirBeginning) {
  EXPECT_EQ(flow_sets({"F", "G"}, 1, 1).size(), 12U);
  const std::vector<SceneSet> sets = flow_sets({"G3", "F5"}, 3, 11);
  ASSERT_EQ(sets.size(), 3U);
  EXPECT_EQ(sets[0].name, "F5, flow of .50 per m^2");
  EXPECT_EQ(sets[1].scenes.size(), 3U);
  EXPECT_EQ(sets[1].scenes[0].name, standing_row_scene(11).name);
  EXPECT_THROW(flow_sets({"F6"}, 1, 1), std::runtime_error);
}

SceneDrive hand_made(bool passed, WhoHit who, bool at_speed) {
  SceneDrive drive;
  drive.passed = passed;
  if (who == WhoHit::robot_standing && !at_speed) return drive;
  drive.contacts = 1;
  drive.judged.push_back({.record = {.at_speed = at_speed, .closing = {.who = who}}});
  return drive;
}

// Of three drives one is late and one touches at speed what the robot drove into.
TEST(SceneGate, SaysWhatIsMissed) {
  const std::vector<SceneDrive> drives{hand_made(true, WhoHit::robot_standing, false),
                                       hand_made(false, WhoHit::robot_standing, false),
                                       hand_made(true, WhoHit::robot_closing, true)};
  EXPECT_EQ(missed({.least_success = 0.33}, drives), "");
  EXPECT_EQ(missed({.least_success = 0.34}, drives), "success 0.333 of 0.340");
  EXPECT_EQ(missed({.most_stuck = 0.05}, drives), "0.333 do not pass of 0.050");
  EXPECT_EQ(missed({.no_robot_closing = true, .no_contact_at_speed = true}, drives),
            "1 contacts that the robot drove into, 1 contacts at speed");
}

}  // namespace
}  // namespace bw
