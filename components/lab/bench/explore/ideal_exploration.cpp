#include "components/lab/bench/explore/ideal_exploration.hpp"

#include <cmath>
#include <optional>

#include "components/explore/explorer.hpp"
#include "components/lab/bench/explore/growing_map.hpp"

namespace bw {
namespace {

using explore::Cell;

constexpr double kToGround = 0.5;  // [m]

class IdealRobot {
 public:
  IdealRobot(const Explorable& place, const IdealExplorationOptions& options)
      : options_(options), seen_(place, options.range), at_(place.start) {
    seen_.look(at_);
  }

  const GrowingMap& seen() const { return seen_; }
  double travel() const { return travel_; }
  Vector2 position() const { return seen_.map().center(at_.column, at_.row); }

  /// For one period; true when it is there, or cannot go on.
  bool go_to(const Vector2& goal) {
    const OccupancyGrid& map = seen_.map();
    const std::vector<bool> safe =
        explore::cells_for_disc(map, options_.radius, {.unknown_is_obstacle = true});
    const std::vector<Cell> end = explore::cells_beside(map, safe, goal, kToGround);
    const std::vector<Cell> begin = explore::cells_beside(map, safe, position(), kToGround);
    if (end.empty() || begin.empty()) return true;
    const std::vector<double> to_go = explore::wavefront(map, safe, end);
    const auto left = [&](Cell c) { return to_go[map.index(c.column, c.row)]; };
    at_ = begin.front();
    const double before = left(at_);
    if (before == explore::kUnreached) return true;
    while (left(at_) > 0.0 && before - left(at_) < options_.speed * options_.period) {
      Cell next = at_;
      explore::for_neighbours(map, at_, [&](Cell c) {
        if (left(c) < left(next)) next = c;
      });
      at_ = next;
      seen_.look(at_);
    }
    travel_ += before - left(at_);
    return left(at_) == 0.0;
  }

 private:
  IdealExplorationOptions options_;
  GrowingMap seen_;
  Cell at_;
  double travel_ = 0.0;
};

}  // namespace

IdealExploration explore_ideally(const Explorable& place, const IdealExplorationOptions& options) {
  IdealRobot robot(place, options);
  explore::Explorer explorer(false);
  const Vector2 start = robot.position();
  explorer.resume({start.x(), start.y(), 0.0});
  std::optional<Vector2> goal;
  for (double time = 0.0; time < options.longest && explorer.state() == explore::ExploreState::exploring;
       time += options.period) {
    const explore::ExploreStep step = explorer.look(
        explore::find_frontiers(robot.seen().map(), robot.position(), {.radius = options.radius}));
    if (step.cancels) goal.reset();
    if (step.goal) goal = step.goal->position();
    if (!goal || !robot.go_to(*goal)) continue;
    goal.reset();
    explorer.goal_ended(explore::GoalEnd::reached, "");
  }
  return {.complete = explorer.state() == explore::ExploreState::complete,
          .travel = robot.travel(),
          .known = robot.seen().share(),
          .goals = explorer.goals(),
          .left = explorer.left().size()};
}

}  // namespace bw
