#include "components/local_planner/hrvo/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "components/model/mover_weight.hpp"
#include "components/model/nearest_point.hpp"

namespace bw::hrvo {
namespace {

constexpr double kSmallestRadius = 1e-6;  // [m]; two points never meet

double gap(const Neighbour& n) { return n.distance - n.radius; }

bool in_view(const PlanningProblem& problem, const Vector2& p, double view_angle) {
  const Vector2 to_p = p - problem.pose.position();
  if (to_p.squaredNorm() == 0.0) return true;
  const double bearing = std::atan2(to_p.y(), to_p.x());
  return std::abs(wrap_angle(bearing - problem.pose.theta)) <= view_angle / 2.0;
}

// The part of `segment` at most `radius` from `center`, whose nearest point is no further.
Segment part_within(const Segment& segment, const Vector2& center, const Vector2& nearest, double radius) {
  const double half_chord2 = radius * radius - (nearest - center).squaredNorm();
  const auto pulled_in = [&](const Vector2& end) {
    const double distance2 = (end - center).squaredNorm();
    if (distance2 <= radius * radius) return end;
    // `end` is seen from `nearest` along the line; solve |nearest + s (end - nearest) - center| = radius.
    const Vector2 d = end - nearest;
    const double b = (nearest - center).dot(d);
    const double a = d.squaredNorm();
    const double s = (std::sqrt(b * b + a * half_chord2) - b) / a;
    return Vector2(nearest + std::clamp(s, 0.0, 1.0) * d);
  };
  return {pulled_in(segment.a), pulled_in(segment.b)};
}

// By gap; what is equally near by all that tells neighbours apart, so that the order given does not matter.
bool nearer(const Neighbour& l, const Neighbour& r) {
  const auto key = [](const Neighbour& n) {
    return std::tuple(gap(n), n.core.a.x(), n.core.a.y(), n.core.b.x(), n.core.b.y(), n.radius,
                      n.velocity.x(), n.velocity.y(), n.shares);
  };
  return key(l) < key(r);
}

void keep_nearest(std::vector<Neighbour>& list, std::int64_t count) {
  std::sort(list.begin(), list.end(), nearer);
  if (static_cast<std::int64_t>(list.size()) > count) list.resize(static_cast<std::size_t>(count));
}

class StaticNeighbours {
 public:
  StaticNeighbours(const PlanningProblem& problem, const Vector2& goal, const HrvoOptions& options)
      : problem_(problem), goal_(goal), options_(options) {}

  void add(const Segment& core, double radius) {
    if (const std::optional<Neighbour> n = as_neighbour(core, radius)) list_.push_back(*n);
  }

  // A wall of points must not use up the places of everything else.
  void add_points(const std::vector<Vector2>& points) {
    std::vector<Neighbour> all;
    for (const Vector2& p : points) {
      if (const std::optional<Neighbour> n = as_neighbour({p, p}, 0.0)) all.push_back(*n);
    }
    keep_nearest(all, static_cast<std::int64_t>(all.size()));
    std::vector<Neighbour> kept;
    for (const Neighbour& n : all) {
      if (static_cast<std::int64_t>(kept.size()) >= options_.max_neighbours) break;
      const double spacing = std::min(kPointSpacing, n.radius);
      const bool stands_alone = std::none_of(kept.begin(), kept.end(), [&](const Neighbour& k) {
        return (k.core.a - n.core.a).squaredNorm() < spacing * spacing;
      });
      if (stands_alone) kept.push_back(n);
    }
    list_.insert(list_.end(), kept.begin(), kept.end());
  }

  std::vector<Neighbour> nearest() && {
    keep_nearest(list_, options_.max_neighbours);
    return std::move(list_);
  }

 private:
  std::optional<Neighbour> as_neighbour(const Segment& core, double radius) const {
    const Vector2 robot = problem_.pose.position();
    const Vector2 nearest = nearest_point(core, robot);
    const double distance = (nearest - robot).norm();
    if (distance > options_.neighbour_range) return {};
    const auto seen = [&](const Vector2& p) { return in_view(problem_, p, options_.view_angle); };
    if (!seen(nearest) && !seen(core.a) && !seen(core.b)) return {};
    const double touching = problem_.footprint.radius + radius;
    double room = distance - touching;
    if (problem_.goal_is_final && !problem_.plan.empty()) {
      const Vector2 end = problem_.plan.back().position();
      const double room_there = (nearest_point(core, end) - end).norm() - touching;
      if (room_there >= 0.0) room = std::min(room, room_there);
    }
    const double reach = (goal_ - robot).norm();
    Neighbour n{core, touching + std::clamp(room, 0.0, options_.margin), {0.0, 0.0}, false, distance};
    if (n.radius < kSmallestRadius || gap(n) >= reach) return {};
    n.core = part_within(core, robot, nearest, n.radius + reach);
    return n;
  }

  const PlanningProblem& problem_;
  Vector2 goal_;
  const HrvoOptions& options_;
  std::vector<Neighbour> list_;
};

}  // namespace

std::vector<Neighbour> moving_neighbours(const PlanningProblem& problem, const HrvoOptions& options) {
  std::vector<Neighbour> list;
  for (const Mover& m : problem.movers) {
    if (!is_confirmed(m)) continue;
    const double distance = (m.position - problem.pose.position()).norm();
    const double radius = problem.footprint.radius + m.radius + options.margin;
    if (distance > options.neighbour_range || !in_view(problem, m.position, options.view_angle)) continue;
    if (radius < kSmallestRadius) continue;
    const bool shares = m.reciprocal || options.reciprocity == Reciprocity::all;
    list.push_back({{m.position, m.position}, radius, m.velocity, shares, distance});
  }
  keep_nearest(list, options.max_neighbours);
  return list;
}

std::vector<Neighbour> static_neighbours(const PlanningProblem& problem, const Vector2& goal,
                                         const HrvoOptions& options) {
  StaticNeighbours statics(problem, goal, options);
  for (const Disc& d : problem.obstacles.discs) statics.add({d.center, d.center}, d.radius);
  for (const Segment& s : problem.obstacles.segments) statics.add(s, 0.0);
  statics.add_points(problem.obstacles.points);
  return std::move(statics).nearest();
}

std::vector<Neighbour> neighbours(const PlanningProblem& problem, const Vector2& goal,
                                  const HrvoOptions& options) {
  std::vector<Neighbour> all = moving_neighbours(problem, options);
  const std::vector<Neighbour> still = static_neighbours(problem, goal, options);
  all.insert(all.end(), still.begin(), still.end());
  keep_nearest(all, static_cast<std::int64_t>(all.size()));
  return all;
}

}  // namespace bw::hrvo
