#include "components/lab/bench/buildings/building_people.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <gtest/gtest.h>

#include "components/lab/bench/buildings/route_follower.hpp"
#include "components/model/differential_drive.hpp"

namespace bw::buildings {
namespace {

constexpr double kStep = 0.02;

struct Walked {
  double distance = 0.0;
  double standing = 0.0;  ///< of late [s]
  double longest_stand = 0.0;
};

// 600 s of 20 people, far from the robot. Their speeds are up to 1.4 m/s and some stand for a minute
// (building_people.cpp); a leg is a disc that a wall must not cut.
TEST(BuildingPeople, WalkAndStandAndAreNeverInWalls) {
  for (const BuildingKind kind : {BuildingKind::office, BuildingKind::warehouse}) {
    const Building building = make_building(kind, 1);
    SCOPED_TRACE(building.name);
    const WallIndex walls(building.walls);
    BuildingPeople people(building, walls, 20, Random(5));
    std::map<std::uint32_t, Walked> walked;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 30'000; ++i) {
      people.step(kStep, {1e4, 1e4});
      ASSERT_EQ(people.people().size(), 20u);
      for (const Person& person : people.people()) {
        Walked& one = walked[person.id];
        const double speed = person.velocity.norm();
        EXPECT_LE(speed, 1.4 + 1e-9);
        one.distance += speed * kStep;
        one.standing = speed > 0.0 ? 0.0 : one.standing + kStep;
        one.longest_stand = std::max(one.longest_stand, one.standing);
      }
      for (const Disc& leg : people.legs())
        least = std::min(least, walls.clearance(leg.center, 1.0) - leg.radius);
    }
    EXPECT_GT(least, 0.0);
    int stood_a_minute = 0;
    for (const auto& [id, one] : walked) {
      EXPECT_GT(one.distance, 100.0) << id;
      stood_a_minute += one.longest_stand > 59.9 ? 1 : 0;
    }
    EXPECT_GT(stood_a_minute, 5);
    EXPECT_LT(stood_a_minute, 20 + 1);
  }
}

// Legs reach 0.286 m from somebody who is kept 0.6 m from the robot's centre: a robot of 0.225 m touches
// none. Among 60 people in an office there is somebody in its way within ten minutes.
TEST(BuildingPeople, StepAsideForTheRobotAndNotIntoWalls) {
  const Building building = make_building(BuildingKind::office, 2);
  const WallIndex walls(building.walls);
  BuildingPeople people(building, walls, 60, Random(6));
  RouteFollower follower(building.route, {});
  Pose2 robot = follower.start();
  double nearest = std::numeric_limits<double>::infinity();
  double least = nearest;
  bool somebody_was_left_out = false;
  for (int i = 0; i < 30'000; ++i) {
    const auto twist = follower.next(robot);
    ASSERT_TRUE(twist);
    robot = advance_exact(robot, *twist, kStep);
    people.step(kStep, robot.position());
    somebody_was_left_out |= people.people().size() < 60;
    for (const Disc& leg : people.legs()) {
      nearest = std::min(nearest, (leg.center - robot.position()).norm() - leg.radius);
      least = std::min(least, walls.clearance(leg.center, 1.0) - leg.radius);
    }
  }
  EXPECT_GT(nearest, 0.225);
  EXPECT_LT(nearest, 0.6);
  EXPECT_GT(least, 0.0);
  EXPECT_TRUE(somebody_was_left_out);  // in a door
}

}  // namespace
}  // namespace bw::buildings
