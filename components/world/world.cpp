#include "components/world/world.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "components/world/random_streams.hpp"

namespace bw {
namespace {

/// Inline walls and boxes, and the recording's shapes moved into map.
StaticObstacles shapes_in_map(const WorldOptions& options, const StaticObstacles& recorded) {
  const ReplayOptions& replay = options.people.replay;
  const Pose2 X_map_recording{replay.x, replay.y, replay.theta};
  StaticObstacles shapes;
  shapes.segments = wall_segments(options);
  for (const Segment& s : recorded.segments)
    shapes.segments.push_back({X_map_recording * s.a, X_map_recording * s.b});
  for (const Disc& d : recorded.discs) shapes.discs.push_back({X_map_recording * d.center, d.radius});
  return shapes;
}

}  // namespace

World::World(const WorldOptions& options, const Robot& robot, const WorldFiles& files, std::uint64_t seed)
    : options_(options),
      robot_(robot),
      step_(Duration::seconds(options.physics_step)),
      scene_(shapes_in_map(options, files.shapes), files.map),
      drive_(options.drive, robot, {options.start.x, options.start.y, wrap_angle(options.start.theta)},
             random_stream(seed, RandomPurpose::wheels)),
      X_base_laser_(robot.mount_of(options.laser.frame)),
      laser_(options.laser, random_stream(seed, RandomPurpose::laser)),
      imu_(options.imu, random_stream(seed, RandomPurpose::imu)),
      gps_(options.gps, random_stream(seed, RandomPurpose::gps)),
      legs_(options.people.legs) {
  if (scene_.clearance(pose().position(), robot_.radius) < robot_.radius) {
    throw std::runtime_error(
        "start (" + std::to_string(options.start.x) + ", " + std::to_string(options.start.y) +
        ") is nearer to a wall than the robot's radius of " + std::to_string(robot_.radius) + " m");
  }
  const PeopleOptions& people = options_.people;
  std::uint32_t next_id = 1;
  groups_.push_back(std::make_unique<ScriptedPeople>(people.scripted, next_id));
  next_id += static_cast<std::uint32_t>(people.scripted.size());
  groups_.push_back(std::make_unique<ReplayedPeople>(
      people.replay, files.tracks, next_id - 1 + static_cast<std::uint32_t>(people.social.walkers.size())));
  groups_.push_back(std::make_unique<SocialWalkers>(people.social, scene_, next_id,
                                                    random_stream(seed, RandomPurpose::walkers)));
  move_people(0.0);  // everybody is there before the first step
}

RobotBody World::robot_body() const {
  return {pose().position(), direction(pose().theta) * twist().v, robot_.radius};
}

double World::wall_gap(double limit) const {
  return scene_.clearance(pose().position(), robot_.radius + limit) - robot_.radius;
}

void World::move_people(double dt) {
  const RobotBody robot = robot_body();
  std::vector<Person> moved;
  for (const auto& group : groups_) {
    const std::vector<Person> others = moved;
    group->step(dt, {others, options_.people_react ? &robot : nullptr}, moved);
  }
  people_ = std::move(moved);
  legs_.step(dt, people_);
}

/// Whether a multiple of 1 / rate lies in the step that has just ended.
bool World::due(double rate) const {
  constexpr double kRounding = 1e-9;
  const double periods = rate * options_.physics_step;
  const auto passed = [&](std::int64_t steps) {
    return std::floor(static_cast<double>(steps) * periods + kRounding);
  };
  return passed(steps_) > passed(steps_ - 1);
}

WorldSample World::step() {
  ++steps_;
  const double speed_before = std::abs(twist().v);
  const bool held_by_wall = drive_.step(options_.physics_step, scene_);
  move_people(options_.physics_step);
  contacts_.step(time(), robot_body(), speed_before, held_by_wall, wall_gap(2.0 * ContactLog::kApart),
                 people_);

  WorldSample sample;
  sample.time = time();
  sample.truth_due = due(options_.truth_rate);
  if (due(options_.encoder_rate)) sample.ticks = drive_.ticks();
  if (due(options_.imu.rate)) sample.imu = imu_.read(pose(), twist());
  if (due(options_.laser.rate))
    sample.scan = laser_.scan(scene_, legs_.discs(people_), pose() * X_base_laser_);
  if (due(options_.gps.rate)) gps_.measure(time(), pose().position());
  sample.fixes = gps_.arrived(time());
  return sample;
}

}  // namespace bw
