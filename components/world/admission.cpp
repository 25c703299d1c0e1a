#include "components/world/admission.hpp"

#include <algorithm>
#include <cmath>

namespace bw {
namespace {

constexpr double kFarthest = 1e5;  // [m] as of everything in a world
constexpr double kThinnest = 0.05;
constexpr double kWidest = 2.0;

bool is_in_range(const Vector2& point) { return point.cwiseAbs().maxCoeff() <= kFarthest; }

/// What the numbers alone are wrong about.
std::string fault_of_numbers(const NewPerson& person) {
  if (!person.position.allFinite() || !person.velocity.allFinite() || !std::isfinite(person.radius) ||
      (person.goal && !person.goal->allFinite()))
    return "a number of the request is not finite";
  if (!is_in_range(person.position) || (person.goal && !is_in_range(*person.goal)))
    return "places lie within 100000 m of the origin";
  if (person.radius < kThinnest || person.radius > kWidest) return "a radius is between 0.05 and 2 m";
  return fault_of_speed(person.velocity);
}

}  // namespace

std::string fault_of_speed(const Vector2& velocity) {
  if (velocity.norm() <= kFastestPerson) return {};
  return "too fast: people go at 3 m/s at most";
}

std::string refusal_of(const NewPerson& person, const StaticScene& scene, std::span<const RobotBody> robots,
                       const std::vector<Person>& people) {
  if (std::string fault = fault_of_numbers(person); !fault.empty()) return fault;
  if (people.size() >= kMaxPeople)
    return "there are " + std::to_string(people.size()) + " people already, which is the most";
  if (scene.clearance(person.position, person.radius) < person.radius)
    return "the position is nearer to a wall than the radius";
  if (person.goal && scene.clearance(*person.goal, person.radius) < person.radius)
    return "the goal is nearer to a wall than the radius";
  const auto overlaps = [&](const auto& other) {
    return (other.position - person.position).norm() < other.radius + person.radius;
  };
  if (std::ranges::any_of(robots, overlaps)) return "a robot stands there";
  if (const auto other = std::ranges::find_if(people, overlaps); other != people.end())
    return "person " + std::to_string(other->id) + " stands there";
  return {};
}

}  // namespace bw
