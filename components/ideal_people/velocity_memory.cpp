#include "components/ideal_people/velocity_memory.hpp"

#include <cmath>
#include <utility>

namespace bw {

void VelocityMemory::smooth(std::vector<Mover>& people, double memory, double dt) {
  if (memory <= 0.0) return velocities_.clear();
  if (dt < 0.0) velocities_.clear();
  const double share = 1.0 - std::exp(-dt / memory);
  std::map<std::uint32_t, Vector2> now;
  for (Mover& person : people) {
    if (!person.velocity.allFinite()) continue;
    if (const auto before = velocities_.find(person.id); before != velocities_.end())
      person.velocity = before->second + share * (person.velocity - before->second);
    now[person.id] = person.velocity;
  }
  velocities_ = std::move(now);
}

}  // namespace bw
