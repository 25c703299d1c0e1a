#include "components/world/world.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "components/world/random_streams.hpp"
#include "components/world/wall_gap.hpp"

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
      step_(Duration::seconds(options.kPhysicsStep)),
      scene_(shapes_in_map(options, files.shapes), files.map),
      X_base_laser_(robot.mount_of(options.laser.frame)),
      legs_(options.people.legs) {
  for (const MoreLaserOptions& one : options.more_lasers) X_base_more_.push_back(robot.mount_of(one.frame));
  if (options.robots.empty()) add_robot(options.start, seed);
  for (const WorldRobotOptions& one : options.robots) add_robot(one.start, seed);
  samples_.resize(robots_.size());
  const PeopleOptions& people = options_.people;
  std::uint32_t next_id = 1;
  groups_.push_back(std::make_unique<ScriptedPeople>(people.scripted, next_id));
  next_id += static_cast<std::uint32_t>(people.scripted.size());
  groups_.push_back(std::make_unique<ReplayedPeople>(
      people.replay, files.tracks,
      next_id - 1 + static_cast<std::uint32_t>(people.social.walkers.size() + people.orca.walkers.size())));
  auto walkers = std::make_unique<SocialWalkers>(people.social, scene_, next_id,
                                                 random_stream(seed, RandomPurpose::walkers));
  walkers_ = walkers.get();
  groups_.push_back(std::move(walkers));
  next_id += static_cast<std::uint32_t>(people.social.walkers.size());
  groups_.push_back(std::make_unique<OrcaWalkers>(people.orca, scene_, next_id,
                                                  random_stream(seed, RandomPurpose::orca_walkers)));
  next_id_ = first_free_id(files.tracks);
  move_people(0.0);  // everybody is there before the first step
}

void World::add_robot(const StartOptions& start, std::uint64_t seed) {
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error("start (" + std::to_string(start.x) + ", " + std::to_string(start.y) +
                             ") is nearer to " + why);
  };
  const Pose2 pose{start.x, start.y, wrap_angle(start.theta)};
  const Footprint footprint = robot_.outline();
  if (bw::wall_gap(scene_, footprint, pose, 0.0) < 0.0)
    refuse(footprint.is_polygon()
               ? std::string("a wall than the robot's footprint")
               : "a wall than the robot's radius of " + std::to_string(footprint.radius) + " m");
  for (const SimulatedRobot& other : robots_) {
    if ((other.drive.pose().position() - pose.position()).norm() < 2.0 * footprint.radius)
      refuse("another robot's than two radii of " + std::to_string(footprint.radius) + " m");
  }
  const std::uint64_t own_seed = robot_seed(seed, robots_.size());
  std::vector<LaserScanner> more;
  for (std::size_t i = 0; i < options_.more_lasers.size(); ++i) {
    const auto purpose =
        static_cast<RandomPurpose>(static_cast<std::uint64_t>(RandomPurpose::more_lasers) + i);
    more.emplace_back(options_.more_lasers[i], random_stream(own_seed, purpose));
  }
  robots_.push_back({DriveModel(options_.drive, robot_, pose, random_stream(own_seed, RandomPurpose::wheels)),
                     LaserScanner(options_.laser, random_stream(own_seed, RandomPurpose::laser)),
                     std::move(more),
                     Imu(options_.imu, random_stream(own_seed, RandomPurpose::imu)),
                     Gps(options_.gps, random_stream(own_seed, RandomPurpose::gps)),
                     {}});
}

/// Behind everybody who is there or will be.
std::uint32_t World::first_free_id(const std::vector<Track>& tracks) const {
  const PeopleOptions& people = options_.people;
  const std::size_t others =
      people.scripted.size() + people.social.walkers.size() + people.orca.walkers.size();
  auto last = static_cast<std::uint32_t>(others);
  for (const Track& track : tracks) last = std::max(last, track.id + static_cast<std::uint32_t>(others));
  return last + 1;
}

World::Admission World::add_person(const NewPerson& person) {
  std::vector<RobotBody> robots;
  for (std::size_t i = 0; i < robots_.size(); ++i) robots.push_back(body(i));
  if (std::string refusal = refusal_of(person, scene_, robots, people_); !refusal.empty())
    return {.refusal = std::move(refusal)};
  if (next_id_ == 0 || next_id_ >= kFirstRobotId) return {.refusal = "no id of a person is left"};
  walkers_->add(next_id_, person);
  people_.push_back(
      {next_id_, person.position, person.goal ? Vector2(0.0, 0.0) : person.velocity, person.radius});
  return {.id = next_id_++};
}

std::string World::push_person(std::uint32_t id, const Vector2& velocity_change) {
  if (!velocity_change.allFinite()) return "a number of the request is not finite";
  if (std::ranges::find(people_, id, &Person::id) == people_.end())
    return "there is no person " + std::to_string(id);
  const bool has_own_path = std::ranges::any_of(groups_, [id](const auto& group) {
    return group->displace(id, {0.0, 0.0});
  });
  if (!has_own_path) return "person " + std::to_string(id) + " walks as recorded";
  Push& push = pushes_.try_emplace(id, options_.people.social.forces.kRelaxationTime).first->second;
  if (std::string fault = fault_of_speed(push.velocity() + velocity_change); !fault.empty()) return fault;
  push.add(velocity_change);
  return {};
}

RobotBody World::body(std::size_t robot) const {
  return {pose(robot).position(), direction(pose(robot).theta) * twist(robot).v, footprint(robot).radius};
}

double World::wall_gap(double limit, std::size_t robot) const {
  return bw::wall_gap(scene_, footprint(robot), pose(robot), limit);
}

std::vector<Person> World::others(std::size_t robot) const {
  std::vector<Person> others = people_;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const RobotBody other = body(i);
    if (i != robot)
      others.push_back(
          {kFirstRobotId + static_cast<std::uint32_t>(i), other.position, other.velocity, other.radius});
  }
  return others;
}

/// Nobody is pushed into a wall: the push ends there.
void World::move_pushed(double dt) {
  for (auto& [id, push] : pushes_) {
    const auto person = std::ranges::find(people_, id, &Person::id);
    if (person == people_.end()) continue;
    const Vector2 by = push.step(dt);
    const double reach = 2.0 * person->radius;
    const double now = scene_.clearance(person->position, reach);
    const double then = scene_.clearance(person->position + by, reach);
    if (then < person->radius && then < now) {
      push.stop();
      continue;
    }
    for (const auto& group : groups_) group->displace(id, by);
  }
  std::erase_if(pushes_, [](const auto& pushed) { return pushed.second.is_over(); });
}

void World::move_people(double dt) {
  move_pushed(dt);
  std::vector<RobotBody> seen;
  for (std::size_t i = 0; options_.people_react && i < robots_.size(); ++i) seen.push_back(body(i));
  std::vector<Person> moved;
  for (const auto& group : groups_) {
    const std::vector<Person> others = moved;
    group->step(dt, {others, seen}, moved);
  }
  people_ = std::move(moved);
  for (const auto& [id, push] : pushes_) {
    const auto person = std::ranges::find(people_, id, &Person::id);
    if (person != people_.end()) person->velocity += push.velocity();
  }
  legs_.step(dt, people_);
}

/// Whether a multiple of 1 / rate lies in the step that has just ended.
bool World::due(double rate) const {
  constexpr double kRounding = 1e-9;
  const double periods = rate * options_.kPhysicsStep;
  const auto passed = [&](std::int64_t steps) {
    return std::floor(static_cast<double>(steps) * periods + kRounding);
  };
  return passed(steps_) > passed(steps_ - 1);
}

const WorldSample& World::step() {
  ++steps_;
  std::vector<double> speed_before;
  std::vector<bool> is_held_by_wall;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    speed_before.push_back(std::abs(twist(i).v));
    is_held_by_wall.push_back(robots_[i].drive.step(options_.kPhysicsStep, scene_));
  }
  move_people(options_.kPhysicsStep);
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    robots_[i].contacts.step(time(), footprint(i), pose(i), speed_before[i], is_held_by_wall[i],
                             wall_gap(2.0 * ContactLog::kApart, i), others(i));
    samples_[i] = {};
    read_sensors(i, samples_[i]);
  }
  return samples_.front();
}

/// What a laser of the robot sees beside what stands: legs, and the other robots.
std::vector<Disc> World::movers_about(std::size_t robot) const {
  std::vector<Disc> movers = legs_.discs(people_);
  for (std::size_t i = 0; i < robots_.size(); ++i)
    if (i != robot) movers.push_back({pose(i).position(), footprint(i).radius});
  return movers;
}

void World::read_sensors(std::size_t robot, WorldSample& sample) {
  SimulatedRobot& own = robots_[robot];
  sample.time = time();
  sample.truth_due = due(options_.truth_rate);
  if (due(options_.encoder_rate)) sample.ticks = own.drive.ticks();
  if (due(options_.imu.rate)) sample.imu = own.imu.read(pose(robot), twist(robot));
  if (due(options_.laser.rate))
    sample.scan = own.laser.scan(scene_, movers_about(robot), pose(robot) * X_base_laser_);
  sample.more_scans.resize(own.more_lasers.size());
  for (std::size_t i = 0; i < own.more_lasers.size(); ++i)
    if (due(options_.more_lasers[i].rate))
      sample.more_scans[i] =
          own.more_lasers[i].scan(scene_, movers_about(robot), pose(robot) * X_base_more_[i]);
  if (due(options_.gps.rate)) own.gps.measure(time(), pose(robot).position());
  sample.fixes = own.gps.arrived(time());
}

}  // namespace bw
