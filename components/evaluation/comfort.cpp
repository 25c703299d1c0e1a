#include "components/evaluation/comfort.hpp"

#include "components/evaluation/collision_index.hpp"

namespace bw {

std::optional<Comfort> comfort_of(const TruthSample& sample, double robot_radius) {
  if (!is_sound(sample)) return std::nullopt;
  const Vector2 robot = sample.X_MB.position();
  Comfort comfort;
  comfort.collision_index = collision_index(robot, sample.people, kJudgingSigma);
  for (const TruePerson& person : sample.people) {
    const double gap = (person.position - robot).norm() - person.radius - robot_radius;
    if (gap >= comfort.closest_person) continue;
    comfort.closest_person = gap;
    comfort.closest_person_id = person.id;
  }
  return comfort;
}

}  // namespace bw
