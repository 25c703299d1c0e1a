#include "components/lab/people_training/training_people.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "components/world/scripted_people.hpp"
#include "components/world/social_walkers.hpp"

namespace bw::people {
namespace {

/// Radius as seen at the laser's height: ankles of 0.025 to 0.06 m at 0.1 m, knees and trousers of 0.05 to
/// 0.095 m at
/// 0.5 m. Recorded scans show thin ones at any height: dark cloth returns nothing where a beam grazes it.
double draw_radius(double height, Random& random) {
  const double up = std::clamp((height - 0.1) / 0.4, 0.0, 1.0);
  const double by_height = random.uniform(0.025 + 0.025 * up, 0.06 + 0.035 * up);
  const double thin = random.uniform(0.025, 0.05);
  return random.uniform() < 0.2 ? thin : by_height;
}

bw::LegOptions draw_legs(const TrainingPeopleOptions& options, bool stands, Random& random) {
  bw::LegOptions legs;
  const double radius = draw_radius(options.laser_height, random);
  // Feet together to a wide stand; who walks keeps the middle.
  const double separation = stands ? random.uniform(2.0 * radius, 0.4) : random.uniform(0.12, 0.3);
  const double swing = random.uniform(0.12, 0.22);
  if (options.restless) {
    legs.sway = 0.003;
    legs.shift_every = 15.0;
  }
  if (!options.varied_legs) return legs;
  legs.radius = radius;
  legs.separation = stands && random.uniform() < 0.3 ? 2.0 * radius : separation;
  legs.swing = swing;
  return legs;
}

/// Those of a group stand in a ring, or walk side by side.
struct Plan {
  std::vector<ScriptedPersonOptions> standing;
  std::vector<double> facing;
  SocialWalkersOptions walking;
};

void plan_group(int size, bool restless, const std::function<Vector2()>& free_position, Random& random,
                Plan& plan) {
  const Vector2 start = free_position();
  const Vector2 goal = free_position();
  const bool stands = random.uniform() < 0.35;
  const double apart = random.uniform(0.5, 0.8);
  const double ring = size > 1 ? apart / (2.0 * std::sin(std::numbers::pi / size)) : 0.0;
  const double rotation = random.uniform(-std::numbers::pi, std::numbers::pi);
  const Vector2 to_goal = goal - start;
  const Vector2 side = direction(std::atan2(to_goal.y(), to_goal.x()) + std::numbers::pi / 2.0);
  for (int i = 0; i < size; ++i) {
    const double bearing = rotation + 2.0 * std::numbers::pi * i / size;
    if (stands) {
      const Vector2 position = start + ring * direction(bearing);
      ScriptedPersonOptions person;
      person.waypoints = {{position.x(), position.y()}};
      if (restless && random.uniform() < 0.5) {  // stands only for a while, or walks up first
        const Vector2 end = free_position();
        person.waypoints.push_back({end.x(), end.y()});
        person.speed = random.uniform(0.5, 1.3);
        person.start_time = random.uniform(0.0, 12.0);
      }
      plan.standing.push_back(person);
      plan.facing.push_back(size > 1 ? bearing + std::numbers::pi : bearing);
    } else {
      const Vector2 offset = apart * (i - (size - 1) / 2.0) * side;
      const Vector2 from = start + offset;
      const Vector2 to = goal + offset;
      plan.walking.walkers.push_back({from.x(), from.y(), to.x(), to.y()});
    }
  }
}

}  // namespace

TrainingPeople::TrainingPeople(const TrainingPeopleOptions& options, const StaticScene& scene,
                               const std::function<Vector2()>& free_position, Random& random) {
  Plan plan;
  plan.walking.speed_min = 0.4;
  plan.walking.speed_max = 1.6;
  plan.walking.forces.social_factor = 5.1;
  for (int left = options.count; left > 0;) {
    const int drawn = random.uniform() < 0.5 ? 1 : 2 + static_cast<int>(random.uniform() * 3.0);
    const int size = std::min(left, drawn);
    plan_group(size, options.restless, free_position, random, plan);
    left -= size;
  }
  for (std::size_t i = 0; i < plan.standing.size(); ++i) {
    legs_.emplace_back(draw_legs(options, true, random));
    // A step on the spot turns them.
    legs_.back().step(0.0, {{static_cast<std::uint32_t>(i + 1), {0.0, 0.0}, direction(plan.facing[i])}});
  }
  for (std::size_t i = 0; i < plan.walking.walkers.size(); ++i)
    legs_.emplace_back(draw_legs(options, false, random));
  const auto first_walker = static_cast<std::uint32_t>(plan.standing.size() + 1);
  groups_.push_back(std::make_unique<ScriptedPeople>(std::move(plan.standing), 1));
  groups_.push_back(
      std::make_unique<SocialWalkers>(plan.walking, scene, first_walker, Random(random.bits())));
}

void TrainingPeople::step(double dt, const RobotBody& robot) {
  people_.clear();
  for (const auto& group : groups_) {
    const std::vector<Person> before = people_;
    group->step(dt, {before, {&robot, 1}}, people_);
  }
  for (const Person& person : people_) legs_[person.id - 1].step(dt, {person});
}

std::vector<Disc> TrainingPeople::legs() const {
  std::vector<Disc> discs;
  for (const Person& person : people_)
    for (const Disc& leg : legs_[person.id - 1].discs({person})) discs.push_back(leg);
  return discs;
}

}  // namespace bw::people
