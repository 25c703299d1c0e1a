// The whole world: contacts, rates, and that one seed is one run.
#include "components/world/world.hpp"

#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "tests/components/world/hallway.hpp"

namespace bw {
namespace {

WheelCommand forward(double speed) { return {speed / Robot().wheel_radius, speed / Robot().wheel_radius}; }

void run(World& world, double seconds) {
  for (int i = 0; i < std::lround(seconds * 100.0); ++i) world.step();
}

TEST(World, CountsAPersonOncePerMeeting) {
  // Walks over the standing robot at 1 m/s, turns after 10 m and comes back: two meetings, at rest.
  WorldOptions options;
  options.people.scripted.resize(1);
  options.people.scripted[0].waypoints = {{-5.0, 0.1}, {5.0, 0.1}};
  options.people.scripted[0].turn_round = true;
  World world(options, Robot(), {}, 1);
  run(world, 4.0);
  EXPECT_EQ(world.contacts().count(ContactKind::person), 0);
  run(world, 2.0);
  ASSERT_EQ(world.contacts().count(ContactKind::person), 1);
  const Contact contact = world.contacts().contacts()[0];
  EXPECT_EQ(contact.person, 1u);
  EXPECT_EQ(contact.robot_speed, 0.0);
  // Touch at |x| = sqrt(0.6^2 - 0.1^2) before the robot, walking from x = -5.
  EXPECT_NEAR(contact.time.to_seconds(), 5.0 - std::sqrt(0.35), 0.011);
  run(world, 10.0);
  EXPECT_EQ(world.contacts().count(ContactKind::person), 2);
  EXPECT_EQ(world.contacts().count(ContactKind::wall), 0);
}

/// The first at (0, 0), the second 4 m ahead of it and facing it.
WorldOptions two_robots() {
  WorldOptions options;
  options.robots = {{.name = "robot1", .start = {0.0, 0.0, 0.0}},
                    {.name = "robot2", .start = {4.0, 0.0, std::numbers::pi}}};
  options.laser.range_noise = 0.0;
  return options;
}

TEST(World, RobotsAreInEachOthersWayAndInTheirLasers) {
  World world(two_robots(), Robot(), {}, 1);
  ASSERT_EQ(world.robot_count(), 2U);
  ASSERT_TRUE(world.command({5.0, 5.0}, 1));  // 5 rad/s of 0.0762 m: 0.381 m/s, the first one stands
  std::optional<LaserScan> scan;
  while (!scan) scan = world.step().scan;
  const auto ahead = static_cast<std::size_t>(std::lround(-scan->angle_min / scan->angle_increment));
  EXPECT_NEAR(scan->ranges.at(ahead), world.pose(1).x - world.pose(0).x - 0.3, 0.005);  // its rim
  run(world, 12.0);  // 4.5 m: through the first one and beyond it
  for (const std::size_t robot : {std::size_t{0}, std::size_t{1}}) {
    ASSERT_EQ(world.contacts(robot).contacts().size(), 1U) << robot;
    const Contact& contact = world.contacts(robot).contacts().front();
    EXPECT_EQ(contact.kind, ContactKind::robot);
    EXPECT_EQ(contact.person, kFirstRobotId + (robot == 0 ? 1 : 0));
    EXPECT_NEAR(contact.robot_speed, robot == 0 ? 0.0 : 0.381, 1e-6);
    EXPECT_NEAR(contact.time.to_seconds(), 3.4 / 0.381, 0.1);  // it starts with 4 m/s^2
  }
  EXPECT_EQ(world.pose(0).x, 0.0);
  EXPECT_TRUE(world.people().empty());
  ASSERT_EQ(world.others(0).size(), 1U);
  EXPECT_NEAR(world.others(0).front().velocity.x(), -0.381, 1e-6);
}

TEST(World, TheFirstOfSeveralRobotsIsAsTheOnlyOne) {
  WorldOptions alone = hallway();
  WorldOptions both = hallway();
  both.people_react = false;
  alone.people_react = false;
  both.robots = {{.name = "a", .start = alone.start}, {.name = "b", .start = {17.0, -2.0, 0.0}}};
  World one(alone, Robot(), {}, 5);
  World two(both, Robot(), {}, 5);
  for (int i = 0; i < 300; ++i) {
    const WorldSample a = one.step();
    const WorldSample b = two.step();
    ASSERT_EQ(a.imu.has_value(), b.imu.has_value());
    if (a.imu) {
      ASSERT_EQ(a.imu->heading, b.imu->heading);
      ASSERT_NE(a.imu->heading, two.samples()[1].imu->heading);  // noises of its own
    }
    ASSERT_EQ(one.people().back().position, two.people().back().position);
  }
}

TEST(World, RefusesRobotsThatStartInEachOther) {
  WorldOptions options = two_robots();
  options.robots[1].start.x = 0.59;
  EXPECT_THROW(World(options, Robot(), {}, 1), std::runtime_error);
  options.robots[1].start.x = 0.61;
  EXPECT_NO_THROW(World(options, Robot(), {}, 1));
}

TEST(World, CountsAWallOncePerTouch) {
  WorldOptions options;
  options.walls = {{3.0, -5.0, 3.0, 5.0}};
  World world(options, Robot(), {}, 1);
  ASSERT_TRUE(world.command(forward(1.0)));
  run(world, 10.0);
  ASSERT_EQ(world.contacts().count(ContactKind::wall), 1);
  EXPECT_NEAR(world.contacts().contacts()[0].robot_speed, 1.0, 1e-9);
  EXPECT_LE(world.pose().x, 2.7);
  ASSERT_TRUE(world.command(forward(-1.0)));
  run(world, 1.0);
  ASSERT_TRUE(world.command(forward(0.5)));
  run(world, 5.0);
  ASSERT_EQ(world.contacts().count(ContactKind::wall), 2);
  EXPECT_NEAR(world.contacts().contacts()[1].robot_speed, 0.5, 1e-9);
}

TEST(World, StopsAtTheSolidCellsOfAMap) {
  OccupancyGrid map{0.05, {-5.0, -5.0}, 200, 200, std::vector<std::int8_t>(40000, 0)};
  for (int row = 0; row < 200; ++row)
    map.cells[map.index(140, row)] = OccupancyGrid::kOccupied;  // x = 2.0 ... 2.05
  WorldFiles files;
  files.map = map;
  World world({}, Robot(), files, 1);
  ASSERT_TRUE(world.command(forward(1.0)));
  run(world, 5.0);
  EXPECT_LE(world.pose().x, 1.7);
  EXPECT_GT(world.pose().x, 1.69);
  EXPECT_EQ(world.contacts().count(ContactKind::wall), 1);
}

TEST(World, RefusesAStartInsideAWall) {
  WorldOptions options;
  options.walls = {{0.2, -5.0, 0.2, 5.0}};
  EXPECT_THROW(World(options, Robot(), {}, 1), std::runtime_error);
}

TEST(World, MovesARecordingWithItsWalls) {
  WorldOptions options;
  options.people.replay.x = 10.0;
  options.people.replay.theta = 1.5707963267948966;
  WorldFiles files;
  files.shapes.segments = {{{1.0, -1.0}, {1.0, 1.0}}};
  files.shapes.discs = {{{3.0, 0.0}, 0.2}};
  const World world(options, Robot(), files, 1);
  EXPECT_NEAR(world.scene().clearance({10.0, 0.0}, 5.0), 1.0, 1e-9);
  EXPECT_NEAR(world.scene().clearance({10.0, 4.0}, 5.0), 0.8, 1e-9);
}

// Two legs 0.12 m to either side of where the recording says, 0.07 m thick, and nothing between them.
TEST(World, ShowsTheLaserTheLegsOfRecordedPeople) {
  WorldOptions options;
  options.laser.range_noise = 0.0;
  WorldFiles files;
  files.tracks = {{.id = 4, .samples = {{0.0, {3.0, 0.0}}, {10.0, {3.0, 0.0}}}}};
  World world(options, Robot(), files, 1);
  std::optional<LaserScan> scan;
  while (!scan) scan = world.step().scan;
  const auto range_at = [&](double angle) {
    return scan->ranges.at(
        static_cast<std::size_t>(std::lround((angle - scan->angle_min) / scan->angle_increment)));
  };
  for (const double side : {-0.12, 0.12})
    EXPECT_NEAR(range_at(std::atan2(side, 3.0)), std::hypot(3.0, side) - 0.07, 0.005);
  EXPECT_TRUE(std::isinf(range_at(0.0)));
}

TEST(World, SensorsKeepTheirRates) {
  WorldOptions options = hallway();
  options.encoder_rate = 30.0;  // not a whole number of steps
  options.gps.latency = 0.25;
  World world(options, Robot(), {}, 1);
  int ticks = 0;
  int scans = 0;
  int readings = 0;
  int fixes = 0;
  int truths = 0;
  for (int i = 0; i < 1000; ++i) {
    const WorldSample sample = world.step();
    EXPECT_EQ(sample.time.nanoseconds, (i + 1) * 10'000'000LL);
    ticks += sample.ticks.has_value();
    scans += sample.scan.has_value();
    readings += sample.imu.has_value();
    truths += sample.truth_due;
    fixes += static_cast<int>(sample.fixes.size());
    for (const GpsFix& fix : sample.fixes)
      EXPECT_NEAR((sample.time - fix.measured_at).to_seconds(), 0.25, 1e-9);
  }
  EXPECT_EQ(ticks, 300);
  EXPECT_EQ(scans, 100);
  EXPECT_EQ(readings, 500);
  EXPECT_EQ(truths, 500);
  EXPECT_EQ(fixes, 9);  // the tenth is still on its way
}

TEST(World, WalkersCrossTheHallwayBetweenItsWalls) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    WorldOptions options = hallway();
    options.people.social.forces.social_factor = seed <= 5 ? 2.1 : 5.1;
    World world(options, Robot(), {}, seed);
    std::vector<double> east(6, 0.0);
    std::vector<double> west(6, 20.0);
    for (int i = 0; i < 6000; ++i) {
      world.step();
      ASSERT_EQ(world.people().size(), 8u);
      for (std::size_t k = 0; k < 6; ++k) {
        const Person& person = world.people()[k + 2];
        ASSERT_EQ(person.id, k + 3);
        ASSERT_LT(std::abs(person.position.y()), 3.0) << "seed " << seed;
        ASSERT_TRUE(person.position.x() > 0.0 && person.position.x() < 20.0) << "seed " << seed;
        east[k] = std::max(east[k], person.position.x());
        west[k] = std::min(west[k], person.position.x());
      }
    }
    for (std::size_t k = 0; k < 6; ++k) {
      // Everybody has been at both ends (goals at 18 and about 4; 18 and 2) within a minute.
      EXPECT_GT(east[k], 16.5) << "seed " << seed << " walker " << k;
      EXPECT_LT(west[k], 5.9) << "seed " << seed << " walker " << k;
    }
  }
}

template <class Value>
void append(std::string& bytes, const Value& value) {
  char raw[sizeof(Value)];
  std::memcpy(raw, &value, sizeof(Value));
  bytes.append(raw, sizeof(Value));
}

std::string everything_of_a_run(std::uint64_t seed) {
  WorldOptions options = hallway();
  options.drive.noise = 1e-4;
  World world(options, Robot(), {}, seed);
  world.command({8.0, 9.0});
  std::string bytes;
  for (int i = 0; i < 1500; ++i) {
    const WorldSample sample = world.step();
    append(bytes, world.pose().x);
    append(bytes, world.pose().theta);
    for (const Person& person : world.people()) append(bytes, person.position.y());
    if (sample.ticks) append(bytes, sample.ticks->right);
    if (sample.imu) append(bytes, sample.imu->heading);
    for (const GpsFix& fix : sample.fixes) append(bytes, fix.latitude);
    if (!sample.scan) continue;
    for (const float range : sample.scan->ranges) append(bytes, range);
  }
  return bytes;
}

TEST(World, OneSeedIsOneRun) {
  const std::string seven = everything_of_a_run(7);
  EXPECT_TRUE(seven == everything_of_a_run(7)) << "seed 7";
  EXPECT_FALSE(seven == everything_of_a_run(8)) << "seeds 7 and 8";
}

TEST(World, ASwitchedOffSensorDoesNotShiftTheOthers) {
  WorldOptions options = hallway();
  World with_all(options, Robot(), {}, 3);
  options.laser.rate = 0.0;
  options.gps.rate = 0.0;
  World without(options, Robot(), {}, 3);
  for (int i = 0; i < 500; ++i) {
    const WorldSample a = with_all.step();
    const WorldSample b = without.step();
    ASSERT_FALSE(b.scan.has_value());
    ASSERT_EQ(a.imu.has_value(), b.imu.has_value());
    if (a.imu) {
      ASSERT_EQ(a.imu->heading, b.imu->heading);
    }
  }
}

}  // namespace
}  // namespace bw
