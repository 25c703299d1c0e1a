// Somebody who walks to a goal, and to and fro: what people by social forces and by ORCA have in common.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "components/model/random.hpp"
#include "components/world/person.hpp"

namespace bw {

struct GoalWalker {
  Person body;
  Vector2 goal;
  Vector2 next_goal;
  double speed = 0.0;  ///< wanted [m/s]
  bool arrived = false;
};

/// One for each of `options.walkers`, at rest at its start, which is moved by up to `start_jitter`; ids count up from `first_id`.
template <class Walker, class Options>
std::vector<Walker> walkers_at_start(const Options& options, std::uint32_t first_id, Random& random) {
  std::vector<Walker> walkers;
  for (const auto& walker : options.walkers) {
    const double jitter = options.start_jitter;
    const double dx = random.uniform(-jitter, jitter);
    const double dy = random.uniform(-jitter, jitter);
    const Vector2 start{walker.x + dx, walker.y + dy};
    const GoalWalker one{{first_id++, start, {0.0, 0.0}, options.radius},
                         {walker.goal_x, walker.goal_y},
                         start,
                         random.uniform(options.speed_min, options.speed_max)};
    walkers.push_back(Walker{one});
  }
  return walkers;
}

/// At the goal it turns round, or has arrived.
template <class Options>
void turn_at_goal(GoalWalker& walker, const Options& options) {
  if ((walker.goal - walker.body.position).norm() > options.goal_tolerance) return;
  walker.arrived = !options.turn_round;
  if (options.turn_round) std::swap(walker.goal, walker.next_goal);
}

/// False when none of them has that id.
template <class Walker>
bool displace_one(std::vector<Walker>& walkers, std::uint32_t id, const Vector2& by) {
  const auto walker = std::ranges::find(walkers, id, [](const Walker& w) { return w.body.id; });
  if (walker == walkers.end()) return false;
  walker->body.position += by;
  return true;
}

}  // namespace bw
