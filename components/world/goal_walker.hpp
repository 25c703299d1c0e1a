// Somebody who walks to a goal, and to and fro: what people by social forces and by ORCA have in common.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "components/model/random.hpp"
#include "components/world/person.hpp"

namespace bw {

struct WalkerOptions {
  double x = 0.0;
  double y = 0.0;
  double goal_x = 0.0;
  double goal_y = 0.0;
  int group = 0;  ///< who has the same number walks together; 0: alone (set by code alone)

  template <class Visitor>
  void fields(Visitor& v) {
    v("x", x, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "start, in map"});
    v("y", y, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "start, in map"});
    v("goal_x", goal_x, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "goal, in map"});
    v("goal_y", goal_y, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "goal, in map"});
  }
};

/// Who walks where: the options that both kinds of walkers have.
struct GoalWalkersOptions {
  std::vector<WalkerOptions> walkers;
  double speed_min = 1.0;
  double speed_max = 1.3;
  double start_jitter = 0.0;
  /// at the goal they walk back to the start, to and fro; else they stand there (set by code alone)
  bool turn_round = true;
  /// [m] nearer than this the goal is reached
  static constexpr double kGoalTolerance = 0.5;
  /// [m] radius of the disc that counts as contact (set by code alone)
  double radius = 0.3;

  template <class Visitor>
  void fields(Visitor& v) {
    v("walkers", walkers, {.doc = "one person each"});
    v("speed_min", speed_min,
      {.unit = "m/s",
       .min = 0,
       .max = 5,
       .doc = "least of the desired speeds, one of which is drawn for each walker"});
    v("speed_max", speed_max, {.unit = "m/s", .min = 0, .max = 5, .doc = "largest of the desired speeds"});
    v("start_jitter", start_jitter,
      {.unit = "m", .min = 0, .max = 10, .doc = "starts are moved by up to this in x and y"});
    v.retired({"goal_tolerance", "turn_round", "radius"}, "a constant of goal_walker.hpp");
  }

  std::optional<std::string> violated_rule() const {
    if (speed_max < speed_min) return "speed_max must be at least speed_min";
    return std::nullopt;
  }
};

struct GoalWalker {
  Person body;
  Vector2 goal;
  Vector2 next_goal;
  double speed = 0.0;  ///< wanted [m/s]
  bool arrived = false;
  int group = 0;
};

/// One for each of `options.walkers`, at rest at its start, which is moved by up to `start_jitter`; ids count
/// up from `first_id`.
template <class Walker>
std::vector<Walker> walkers_at_start(const GoalWalkersOptions& options, std::uint32_t first_id,
                                     Random& random) {
  std::vector<Walker> walkers;
  for (const WalkerOptions& walker : options.walkers) {
    const double jitter = options.start_jitter;
    const double dx = random.uniform(-jitter, jitter);
    const double dy = random.uniform(-jitter, jitter);
    const Vector2 start{walker.x + dx, walker.y + dy};
    const GoalWalker one{{first_id++, start, {0.0, 0.0}, options.radius},
                         {walker.goal_x, walker.goal_y},
                         start,
                         random.uniform(options.speed_min, options.speed_max),
                         false,
                         walker.group};
    walkers.push_back(Walker{one});
  }
  return walkers;
}

/// At the goal it turns round, or has arrived.
inline void turn_at_goal(GoalWalker& walker, const GoalWalkersOptions& options) {
  if ((walker.goal - walker.body.position).norm() > options.kGoalTolerance) return;
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
