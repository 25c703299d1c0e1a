#include "components/local_planner/dwa/led_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include "components/local_planner/plan_line.hpp"
#include "components/model/capsule_index.hpp"
#include "components/model/mover_weight.hpp"

namespace bw::dwa {
namespace {

constexpr double kAhead = 6.0;       // [m] of the plan that are looked at
constexpr double kBehind = 1.5;      // [m] by which the grid goes beyond robot and target
constexpr double kAside = 3.0;       // [m] to either side
constexpr double kCell = 0.1;        // [m]
constexpr double kLook = 0.05;       // [m] between two looks along a line
constexpr double kRejoin = 0.4;      // [m] after the last blocked position
constexpr double kComfort = 0.15;    // [m] more than needed, for which a path may be twice as long
constexpr double kOwnRadius = 0.25;  // [m] around the robot that is free whatever stands there
constexpr int kFar = std::numeric_limits<int>::max();

class Obstacles {
 public:
  explicit Obstacles(const PlanningProblem& problem) {
    StaticObstacles all = problem.obstacles;
    for (const Mover& m : problem.movers) {
      if (is_confirmed(m) && m.velocity.norm() < kStanding) all.discs.push_back({m.position, m.radius});
    }
    index_ = CapsuleIndex(capsules_of(all));
  }
  /// To the nearest [m]; at most `enough`.
  double distance(const Vector2& p, double enough) const {
    double least = enough;
    index_.visit_near(p, enough, [&](const CapsuleIndex::Group& group) {
      for (const std::uint32_t i : index_.members(group))
        least = std::min(least, distance_to(p, index_.capsules()[i]).distance);
    });
    return least;
  }
  double least_along(const Vector2& a, const Vector2& b, double enough) const {
    double least = enough;
    const int looks = std::max(1, static_cast<int>(std::ceil((b - a).norm() / kLook)));
    for (int i = 0; i <= looks; ++i) least = std::min(least, distance(a + (b - a) * i / looks, least));
    return least;
  }

 private:
  CapsuleIndex index_;
};

// Cells around the straight path from the robot to the position where the plan is joined again, along it and
// across.
class Grid {
 public:
  Grid(const Vector2& robot, const Vector2& target, const Obstacles& obstacles, double needed)
      : X_({robot.x(), robot.y(), std::atan2((target - robot).y(), (target - robot).x())}),
        before_(static_cast<int>(kBehind / kCell)),
        aside_(static_cast<int>(kAside / kCell)),
        target_(static_cast<int>(std::lround((target - robot).norm() / kCell))),
        columns_(2 * before_ + target_ + 1),
        rows_(2 * aside_ + 1) {
    price_.resize(static_cast<std::size_t>(columns_ * rows_));
    for (int i = 0; i < columns_ * rows_; ++i) {
      const double room = obstacles.distance(position(i), needed + kComfort);
      const bool own = (position(i) - robot).norm() <= kOwnRadius || i == cell(target_, 0);
      price_[static_cast<std::size_t>(i)] = room >= needed + kComfort ? 1 : room >= needed || own ? 2 : 0;
    }
  }

  /// From the robot to the target; nothing when no path leads there. Among equals the one nearer to the
  /// straight path.
  std::optional<std::vector<Vector2>> path() const {
    const std::vector<int> left = costs_to_target();
    int at = cell(0, 0);
    if (left[static_cast<std::size_t>(at)] == kFar) return std::nullopt;
    std::vector<Vector2> points{position(at)};
    while (at != cell(target_, 0)) {
      std::tuple best{kFar, kFar, kFar, at};
      for_each_neighbour(at, [&](int next, int length) {
        const int to_go = left[static_cast<std::size_t>(next)];
        if (to_go == kFar || price_[static_cast<std::size_t>(next)] == 0) return;
        const int row = next / columns_ - aside_;
        best = std::min(best, std::tuple{to_go + length * price_[static_cast<std::size_t>(next)],
                                         std::abs(row), row, next});
      });
      at = std::get<3>(best);
      points.push_back(position(at));
    }
    return points;
  }

 private:
  int cell(int along, int across) const { return (across + aside_) * columns_ + along + before_; }
  Vector2 position(int i) const {
    return X_ * Vector2(kCell * (i % columns_ - before_), kCell * (i / columns_ - aside_));
  }
  template <class Visit>
  void for_each_neighbour(int i, Visit&& visit) const {
    const int column = i % columns_, row = i / columns_;
    for (int dr = -1; dr <= 1; ++dr) {
      for (int dc = -1; dc <= 1; ++dc) {
        const int c = column + dc, r = row + dr;
        if ((dc == 0 && dr == 0) || c < 0 || r < 0 || c >= columns_ || r >= rows_) continue;
        visit(r * columns_ + c, dc != 0 && dr != 0 ? 14 : 10);
      }
    }
  }
  // In whole numbers, so that nothing hangs on the order of sums.
  std::vector<int> costs_to_target() const {
    std::vector<int> left(price_.size(), kFar);
    using Entry = std::pair<int, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    left[static_cast<std::size_t>(cell(target_, 0))] = 0;
    open.push({0, cell(target_, 0)});
    while (!open.empty()) {
      const auto [so_far, i] = open.top();
      open.pop();
      if (so_far > left[static_cast<std::size_t>(i)]) continue;
      if (i == cell(0, 0)) break;
      for_each_neighbour(i, [&](int next, int length) {
        if (price_[static_cast<std::size_t>(next)] == 0) return;
        // Paid for the cell that is left for this one, as on the way from the robot.
        const int total = so_far + length * std::max(1, price_[static_cast<std::size_t>(i)]);
        if (total >= left[static_cast<std::size_t>(next)]) return;
        left[static_cast<std::size_t>(next)] = total;
        open.push({total, next});
      });
    }
    return left;
  }

  Pose2 X_;  // the robot, looking at the target
  int before_, aside_, target_, columns_, rows_;
  std::vector<int> price_;  // 0: no path through; 2: nearer than it need be
};

// Straight where that passes no nearer than the path does.
std::vector<Vector2> pulled_straight(const std::vector<Vector2>& path, const Obstacles& obstacles,
                                     double enough) {
  std::vector<Vector2> pulled{path.front()};
  for (std::size_t from = 0; from + 1 < path.size();) {
    std::size_t to = from + 1;
    double room = enough;
    for (std::size_t i = from + 1; i < path.size(); ++i) {
      room = std::min(room, obstacles.distance(path[i], enough));
      if (obstacles.least_along(path[from], path[i], enough) >= room - 1e-9) to = i;
    }
    pulled.push_back(path[to]);
    from = to;
  }
  return pulled;
}

}  // namespace

std::vector<Pose2> led_plan(const PlanningProblem& problem, double margin) {
  const Vector2 robot = problem.pose.position();
  const PlanLine line(problem.plan, robot, 0.0);
  const double begin = line.nearest(robot, 0.0, line.length()).along;
  const double end = std::min(line.length(), begin + kAhead);
  const Obstacles obstacles(problem);
  const double fits = inscribed_radius(problem.footprint);
  const double needed = fits + margin;
  // Of a robot that is wider than the grid, or inside of something, no path leads anywhere.
  if (needed > kAside || obstacles.distance(robot, fits) < 0.0) return problem.plan;
  double last_blocked = -1.0;
  const int looks = static_cast<int>((end - begin) / kLook);
  for (int i = 0; i <= looks; ++i) {
    if (obstacles.distance(line.at(begin + i * kLook), fits) < fits) last_blocked = begin + i * kLook;
  }
  if (last_blocked < 0.0) return problem.plan;
  double join = std::min(line.length(), last_blocked + kRejoin);
  while (join < line.length() && obstacles.distance(line.at(join), needed) < needed) join += kLook;
  const Vector2 target = line.at(std::min(join, line.length()));
  if ((target - robot).norm() > 2.0 * kAhead || obstacles.distance(target, needed) < needed)
    return problem.plan;
  const std::optional<std::vector<Vector2>> path = Grid(robot, target, obstacles, needed).path();
  if (!path) return problem.plan;
  std::vector<Pose2> led;
  for (const Vector2& p : pulled_straight(*path, obstacles, needed + kComfort))
    led.push_back({p.x(), p.y(), 0.0});
  double along = 0.0;
  for (std::size_t i = 0; i < problem.plan.size(); ++i) {
    if (i > 0) along += (problem.plan[i].position() - problem.plan[i - 1].position()).norm();
    if (along > join) led.push_back(problem.plan[i]);
  }
  led.push_back(problem.plan.back());
  return led;
}

}  // namespace bw::dwa
