#include "components/world/legs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bw {

void Legs::step(double dt, const std::vector<Person>& people) {
  constexpr double kStanding = 0.05;  // [m/s], slower than this nobody turns
  for (const Person& person : people) {
    const double speed = person.velocity.norm();
    Gait& gait = gaits_[person.id];
    gait.walked += speed * dt;
    if (speed > kStanding) gait.facing = person.velocity / speed;
  }
}

std::vector<Disc> Legs::discs(const std::vector<Person>& people) const {
  std::vector<Disc> legs;
  legs.reserve(2 * people.size());
  for (const Person& person : people) {
    const auto found = gaits_.find(person.id);
    const Gait gait = found == gaits_.end() ? Gait{} : found->second;
    const double share = std::min(1.0, person.velocity.norm() / options_.full_swing_speed);
    const double phase = 2.0 * std::numbers::pi * gait.walked / options_.stride;
    const Vector2 forward = gait.facing * (share * options_.swing * std::sin(phase));
    const Vector2 left = Vector2(-gait.facing.y(), gait.facing.x()) * (options_.separation / 2.0);
    legs.push_back({person.position + left + forward, options_.radius});
    legs.push_back({person.position - left - forward, options_.radius});
  }
  return legs;
}

}  // namespace bw
