#include <algorithm>
#include <cmath>
#include <numbers>

#include "components/lab/bench/flows/flow_frame.hpp"
#include "components/lab/bench/flows/flow_scenes.hpp"
#include "components/lab/bench/scene_actors.hpp"

namespace bw {
namespace {

const Vector2 kOffStage(0.0, -100.0);  // where somebody is before they come

// From place to place at one speed, then on as it went last.
std::function<void(double, const SceneRobot&, SceneDisc&)> along(std::vector<Vector2> places, double speed) {
  return [places, speed, next = std::size_t{0}](double, const SceneRobot&, SceneDisc& disc) mutable {
    while (next < places.size() && (places[next] - disc.position).norm() < speed * kSceneStep) ++next;
    if (next < places.size()) disc.velocity = speed * (places[next] - disc.position).normalized();
    disc.position += kSceneStep * disc.velocity;
  };
}

// Who stands about: a little to and fro.
SceneActor standing(const Vector2& place, std::uint32_t id, Random& random) {
  constexpr double kSway = 0.03;  // [m]
  const double heading = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double phase = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double rate = 2.0 * std::numbers::pi * random.uniform(0.1, 0.3);
  const auto at = [=](double time) -> Vector2 {
    return place + kSway * std::sin(phase + rate * time) * direction(heading);
  };
  const auto rule = [=](double time, const SceneRobot&, SceneDisc& disc) {
    disc.position = at(time + kSceneStep);
    disc.velocity = kSway * rate * std::cos(phase + rate * (time + kSceneStep)) * direction(heading);
  };
  return {{.id = id, .position = at(0.0)}, rule};
}

constexpr double kRowX = 4.0;    // [m] to those who stand in a row
constexpr double kRowGap = 0.8;  // [m] between outlines
constexpr double kRowRadius = 0.3;
constexpr int kRowPeople = 4;      // people across the corridor
constexpr double kRowTold = 10.0;  // [s] after the robot can be there, within which it says so

// All gaps alike, but for that of number `open` of kRowPeople + 1, the first and the last of which are at the walls.
DriveScene row_scene(const char* name, std::uint64_t seed, int open) {
  DriveScene scene = in_a_corridor(name, seed, kFlowHalfWidth, 8.0, 30.0);
  Random random(seed);
  const double room = 2.0 * kFlowHalfWidth - 2.0 * kRowRadius * kRowPeople;
  const double gap = open < 0 ? room / (kRowPeople + 1) : (room - kRowGap) / kRowPeople;
  std::vector<SceneActor> actors;
  double y = -kFlowHalfWidth;
  for (int k = 0; k < kRowPeople; ++k) {
    y += (k == open ? kRowGap : gap) + kRowRadius;
    actors.push_back(standing({kRowX, y}, static_cast<std::uint32_t>(k), random));
    y += kRowRadius;
  }
  scene.movers = std::make_shared<SceneActors>(actors);
  return scene;
}

}  // namespace

// They wait before the door while the robot is nearer to it and not yet through.
DriveScene door_scene(std::uint64_t seed) {
  static constexpr double kDoorX = 4.0;
  constexpr double kDoorHalfWidth = 0.45;
  constexpr double kRoomHalfWidth = 2.5;
  constexpr double kWaitFrom = 1.0, kWaitTo = 1.6;  // [m] before the door
  DriveScene scene = along_the_middle("door", seed, 8.0, 30.0);
  add_walls_along(scene.walls, kRoomHalfWidth, -2.0, 14.0);
  for (const double side : {-1.0, 1.0})
    scene.walls.segments.push_back({{kDoorX, side * kDoorHalfWidth}, {kDoorX, side * kRoomHalfWidth}});
  Random random(seed);
  scene.start = {0.0, random.uniform(-1.5, 1.5), 0.0};
  scene.path = [](const Pose2& pose) {
    const double past = std::max(kDoorX, pose.x) + kFlowAhead;
    if (pose.x >= kDoorX) return std::vector<Pose2>{{pose.x, 0.0, 0.0}, {past, 0.0, 0.0}};
    const double heading = std::atan2(-pose.y, kDoorX - pose.x);
    return std::vector<Pose2>{{pose.x, pose.y, heading}, {kDoorX, 0.0, heading}, {past, 0.0, 0.0}};
  };
  SocialWalkersOptions options = flow_walkers();
  const double from = kDoorX + random.uniform(2.0, 7.0);
  const double y = random.uniform(-1.5, 1.5);
  options.walkers = {{from, y, 2.0 * kDoorX - from, -y}};
  const auto waits = [](const SceneDisc& person, const SceneRobot& robot) {
    const Vector2 door(kDoorX, 0.0);
    const double ahead = person.position.x() - kDoorX;
    return ahead > kWaitFrom && ahead < kWaitTo && robot.position.x() < kDoorX + 0.3 &&
           (robot.position - door).norm() < (person.position - door).norm();
  };
  scene.movers = std::make_shared<SocialPeople>(options, scene.walls, seed, SceneLoop{}, waits);
  return scene;
}

// The bar of the T is the corridor; the stem joins it from one side. Nobody is known to be there until they stand in its mouth.
DriveScene corner_scene(std::uint64_t seed) {
  constexpr double kBarHalfWidth = 1.0;
  constexpr double kStemFrom = 5.0, kStemTo = 7.0;
  DriveScene scene = along_the_middle("corner", seed, 9.0, 30.0);
  Random random(seed);
  const double side = random.uniform() < 0.5 ? -1.0 : 1.0;
  const double y = side * kBarHalfWidth;
  scene.walls.segments = {{{kFlowLoop.from, -y}, {kFlowLoop.to, -y}},
                          {{kFlowLoop.from, y}, {kStemFrom, y}},
                          {{kStemTo, y}, {kFlowLoop.to, y}},
                          {{kStemFrom, y}, {kStemFrom, 5.0 * y}},
                          {{kStemTo, y}, {kStemTo, 5.0 * y}}};
  const Vector2 mouth(random.uniform(kStemFrom + 0.4, kStemTo - 0.4), y);
  const double appears = random.uniform(1.0, 2.5);  // [m] ahead of the robot
  const double turn = random.uniform() < 0.5 ? -1.0 : 1.0;
  const Vector2 lane = mouth + Vector2(0.5 * turn, -side * random.uniform(0.4, 0.8));
  const auto walk = along({lane, lane + Vector2(turn * kFlowFar, 0.0)}, random.uniform(1.0, 1.4));
  const auto rule = [=](double time, const SceneRobot& robot, SceneDisc& disc) mutable {
    if (disc.id == 1) return walk(time, robot, disc);
    if (mouth.x() - robot.position.x() > appears) return;
    disc.id = 1;
    disc.position = mouth;
    walk(time, robot, disc);
  };
  scene.movers = std::make_shared<SceneActors>(std::vector<SceneActor>{{{.position = kOffStage}, rule}});
  return scene;
}

DriveScene standing_row_scene(std::uint64_t seed) {
  return row_scene("row with a gap", seed, static_cast<int>(Random(seed).bits() % (kRowPeople + 1)));
}

DriveScene closed_row_scene(std::uint64_t seed) {
  DriveScene scene = row_scene("closed row", seed, -1);
  scene.timeout = kRowX / scene.limits.v_max + kRowTold;
  scene.is_blocked = true;
  return scene;
}

// Who only follows is late: 15 m at 0.5 m/s from 2 m ahead take 26 s.
DriveScene overtaking_scene(std::uint64_t seed) {
  DriveScene scene = in_a_corridor("overtaking", seed, 0.9, kFlowLength, 25.0);
  Random random(seed);
  const double side = random.uniform() < 0.5 ? -1.0 : 1.0;
  const Vector2 start(random.uniform(1.5, 3.0), side * random.uniform(0.35, 0.55));
  scene.movers =
      std::make_shared<SceneActors>(std::vector<SceneActor>{{{.position = start, .velocity = {0.5, 0.0}}}});
  return scene;
}

// At the robot wherever it goes, and straight on from 2 m before it.
DriveScene rusher_scene(std::uint64_t seed) {
  static constexpr double kRush = 1.6;  // [m/s]
  constexpr double kCommits = 2.0;      // [m]
  DriveScene scene = in_a_corridor("rusher", seed, kFlowHalfWidth, 10.0, 30.0);
  Random random(seed);
  const double x = random.uniform(5.0, 9.0);
  const Vector2 start(x, random.uniform(-1.5, 1.5));
  const auto rule = [committed = false](double, const SceneRobot& robot, SceneDisc& disc) mutable {
    const Vector2 to_robot = robot.position - disc.position;
    committed = committed || to_robot.norm() < kCommits;
    if (!committed) disc.velocity = kRush * to_robot.normalized();
    disc.position += kSceneStep * disc.velocity;
  };
  scene.movers = std::make_shared<SceneActors>(std::vector<SceneActor>{{{.position = start}, rule}});
  return scene;
}

// To places drawn in the robot's way, and a while in each.
DriveScene child_scene(std::uint64_t seed) {
  constexpr double kChildRadius = 0.2;
  DriveScene scene = in_a_corridor("child", seed, kFlowHalfWidth, 10.0, 30.0);
  const auto place = [](Random& random) {
    const double x = random.uniform(3.0, 8.0);
    return Vector2(x, random.uniform(-1.5, 1.5));
  };
  Random random(seed);
  const Vector2 start = place(random);
  const auto rule = [place, random, goal = start, speed = 0.0, until = 0.0](double time, const SceneRobot&,
                                                                            SceneDisc& disc) mutable {
    disc.velocity.setZero();
    if (time < until) return;
    const Vector2 way = goal - disc.position;
    if (way.norm() <= speed * kSceneStep + 1e-9) {
      disc.position = goal;
      until = time + random.uniform(0.3, 1.5);
      goal = place(random);
      speed = random.uniform(0.8, 1.6);
      return;
    }
    disc.velocity = speed * way.normalized();
    disc.position += kSceneStep * disc.velocity;
  };
  scene.movers = std::make_shared<SceneActors>(
      std::vector<SceneActor>{{{.position = start, .radius = kChildRadius}, rule}});
  return scene;
}

}  // namespace bw
