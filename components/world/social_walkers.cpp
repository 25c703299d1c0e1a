#include "components/world/social_walkers.hpp"

#include <algorithm>
#include <cmath>

namespace bw {
namespace {

constexpr double kNegligible = 0.01;    // [m/s^2]
constexpr double kLost = 5.0;           // [m] from one of a group to another who is not waited for any more
constexpr double kSpeedHeadroom = 1.3;  // people hurry at most this much (Helbing and Molnar 1995)

}  // namespace

SocialWalkers::SocialWalkers(const SocialWalkersOptions& options, const StaticScene& scene,
                             std::uint32_t first_id, Random random)
    : options_(options), scene_(scene) {
  const SocialForceOptions& forces = options_.forces;
  wall_reach_ = forces.obstacle_sigma * std::log(std::max(1.0, forces.kObstacleFactor / kNegligible));
  walkers_ = walkers_at_start<Walker>(options_, first_id, random);
  forces_.resize(walkers_.size());
}

void SocialWalkers::add(std::uint32_t id, const NewPerson& person) {
  Walker walker{{{id, person.position, {0.0, 0.0}, person.radius},
                 person.goal.value_or(person.position),
                 person.position,
                 person.velocity.norm()}};
  if (person.goal && walker.speed == 0.0) walker.speed = 0.5 * (options_.speed_min + options_.speed_max);
  if (!person.goal) {
    walker.course = person.velocity;
    walker.body.velocity = person.velocity;
  }
  walkers_.push_back(walker);
  forces_.resize(walkers_.size());
}

bool SocialWalkers::displace(std::uint32_t id, const Vector2& by) { return displace_one(walkers_, id, by); }

Vector2 SocialWalkers::pull_of_group(const Walker& walker) const {
  if (walker.group == 0) return {0.0, 0.0};
  Vector2 sum{0.0, 0.0};
  int members = 0;
  for (const Walker& other : walkers_) {
    if (other.group != walker.group) continue;
    if ((other.body.position - walker.body.position).norm() > kLost) continue;
    sum += other.body.position;
    ++members;
  }
  return group_force(options_.forces, sum / members - walker.body.position, members);
}

Vector2 SocialWalkers::force_on(const Walker& walker, const Surroundings& surroundings) const {
  const Person& me = walker.body;
  const Vector2 to_goal = walker.goal - me.position;
  const double distance = to_goal.norm();
  Vector2 desired{0.0, 0.0};
  if (!walker.arrived && distance > 0.0) desired = to_goal * (walker.speed / distance);
  if (walker.course) desired = *walker.course;
  Vector2 force = desired_force(options_.forces, desired, me.velocity) + pull_of_group(walker);

  const auto add = [&](const Vector2& position, const Vector2& velocity) {
    force += social_force(options_.forces, position - me.position, me.velocity - velocity);
  };
  for (const Walker& other : walkers_) {
    if (&other != &walker) add(other.body.position, other.body.velocity);
  }
  for (const Person& other : surroundings.others) add(other.position, other.velocity);
  for (const RobotBody& robot : surroundings.robots) add(robot.position, robot.velocity);

  if (const auto wall = scene_.nearest_point(me.position, me.radius + wall_reach_)) {
    force += obstacle_force(options_.forces, me.position - *wall, me.radius);
  }
  return force;
}

void SocialWalkers::step(double dt, const Surroundings& surroundings, std::vector<Person>& people) {
  // All forces come from one instant; only then does anybody move.
  for (std::size_t i = 0; i < walkers_.size(); ++i) forces_[i] = force_on(walkers_[i], surroundings);
  for (std::size_t i = 0; i < walkers_.size(); ++i) {
    Walker& walker = walkers_[i];
    Person& body = walker.body;
    body.velocity += forces_[i] * dt;
    const double speed = body.velocity.norm();
    const double most = kSpeedHeadroom * walker.speed;
    if (speed > most) body.velocity *= most / speed;
    body.position += body.velocity * dt;
    if (!walker.course) turn_at_goal(walker, options_);
    people.push_back(body);
  }
}

}  // namespace bw
