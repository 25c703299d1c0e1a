#include "components/evaluation/comfort.hpp"

#include "components/evaluation/collision_index.hpp"
#include "components/model/rim_gap.hpp"

namespace bw {

std::optional<Comfort> comfort_of(const TruthSample& sample, const Footprint& robot) {
  if (!is_sound(sample)) return std::nullopt;
  Comfort comfort;
  comfort.collision_index = collision_index(sample.X_MB.position(), sample.people, kJudgingSigma);
  for (const TruePerson& person : sample.people) {
    const double gap = rim_gap(robot, sample.X_MB, person.position, person.radius);
    if (gap >= comfort.closest_person) continue;
    comfort.closest_person = gap;
    comfort.closest_person_id = person.id;
  }
  return comfort;
}

}  // namespace bw
