#include "components/world/social_walkers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bw {
namespace {

constexpr double kNegligible = 0.01;    // [m/s^2]
constexpr double kSpeedHeadroom = 1.3;  // people hurry at most this much (Helbing and Molnar 1995)

}  // namespace

SocialWalkers::SocialWalkers(const SocialWalkersOptions& options, const StaticScene& scene,
                             std::uint32_t first_id, Random random)
    : options_(options), scene_(scene) {
  const SocialForceOptions& forces = options_.forces;
  wall_reach_ = forces.obstacle_sigma * std::log(std::max(1.0, forces.obstacle_factor / kNegligible));
  for (const WalkerOptions& walker : options_.walkers) {
    const double jitter = options_.start_jitter;
    const double dx = random.uniform(-jitter, jitter);
    const double dy = random.uniform(-jitter, jitter);
    const Vector2 start{walker.x + dx, walker.y + dy};
    walkers_.push_back({{first_id++, start, {0.0, 0.0}, options_.radius},
                        {walker.goal_x, walker.goal_y},
                        start,
                        random.uniform(options_.speed_min, options_.speed_max)});
  }
  forces_.resize(walkers_.size());
}

void SocialWalkers::add(std::uint32_t id, const NewPerson& person) {
  Walker walker{{id, person.position, {0.0, 0.0}, person.radius},
                person.goal.value_or(person.position),
                person.position,
                person.velocity.norm()};
  if (person.goal && walker.desired_speed == 0.0)
    walker.desired_speed = 0.5 * (options_.speed_min + options_.speed_max);
  if (!person.goal) {
    walker.course = person.velocity;
    walker.body.velocity = person.velocity;
  }
  walkers_.push_back(walker);
  forces_.resize(walkers_.size());
}

bool SocialWalkers::displace(std::uint32_t id, const Vector2& by) {
  const auto walker = std::ranges::find(walkers_, id, [](const Walker& w) { return w.body.id; });
  if (walker == walkers_.end()) return false;
  walker->body.position += by;
  return true;
}

Vector2 SocialWalkers::force_on(const Walker& walker, const Surroundings& surroundings) const {
  const Person& me = walker.body;
  const Vector2 to_goal = walker.goal - me.position;
  const double distance = to_goal.norm();
  Vector2 desired{0.0, 0.0};
  if (!walker.arrived && distance > 0.0) desired = to_goal * (walker.desired_speed / distance);
  if (walker.course) desired = *walker.course;
  Vector2 force = desired_force(options_.forces, desired, me.velocity);

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

void SocialWalkers::check_goal(Walker& walker) const {
  if (walker.course) return;
  if ((walker.goal - walker.body.position).norm() > options_.goal_tolerance) return;
  walker.arrived = !options_.turn_round;
  if (options_.turn_round) std::swap(walker.goal, walker.next_goal);
}

void SocialWalkers::step(double dt, const Surroundings& surroundings, std::vector<Person>& people) {
  // All forces come from one instant; only then does anybody move.
  for (std::size_t i = 0; i < walkers_.size(); ++i) forces_[i] = force_on(walkers_[i], surroundings);
  for (std::size_t i = 0; i < walkers_.size(); ++i) {
    Walker& walker = walkers_[i];
    Person& body = walker.body;
    body.velocity += forces_[i] * dt;
    const double speed = body.velocity.norm();
    const double most = kSpeedHeadroom * walker.desired_speed;
    if (speed > most) body.velocity *= most / speed;
    body.position += body.velocity * dt;
    check_goal(walker);
    people.push_back(body);
  }
}

}  // namespace bw
