#include "components/local_planner/homotopy/class_search.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

#include "components/local_planner/homotopy/winding.hpp"

namespace bw::homotopy {
namespace {

// Length of the shortest path from each vertex to the goal; infinite where there is none.
std::vector<double> lengths_to_go(const Roadmap& map) {
  std::vector<double> to_go(map.vertices.size(), INFINITY);
  to_go.back() = 0.0;
  for (std::size_t i = map.goal(); i-- > 0;) {
    for (const RoadmapEdge& e : map.edges[i]) to_go[i] = std::min(to_go[i], e.length + to_go[e.to]);
  }
  return to_go;
}

// A path to a vertex, and how it crosses the cut of each body.
struct Partial {
  std::size_t vertex;
  std::size_t parent;
  double length;
  std::vector<int> crossings;
};

std::vector<Vector2> points_of(const std::vector<Partial>& partials, std::size_t last, const Roadmap& map) {
  std::vector<Vector2> points;
  for (std::size_t k = last;; k = partials[k].parent) {
    points.push_back(map.vertices[partials[k].vertex]);
    if (k == 0) break;
  }
  std::reverse(points.begin(), points.end());
  return points;
}

class DepthFirst {
 public:
  DepthFirst(const Roadmap& map, int max_expansions, const VisitPath& visit)
      : map_(map), max_expansions_(max_expansions), visit_(visit), to_go_(lengths_to_go(map)) {}

  int run() {
    points_.push_back(map_.vertices.front());
    descend(0, 0.0);
    return expanded_;
  }

 private:
  // False once the search has ended.
  bool descend(std::size_t vertex, double length) {
    if (vertex == map_.goal()) return visit_(points_, length);
    if (std::isinf(to_go_[vertex])) return true;
    if (expanded_ == max_expansions_) return false;
    ++expanded_;
    std::vector<RoadmapEdge> next = map_.edges[vertex];
    std::stable_sort(next.begin(), next.end(), [&](const RoadmapEdge& l, const RoadmapEdge& r) {
      return l.length + to_go_[l.to] < r.length + to_go_[r.to];
    });
    for (const RoadmapEdge& e : next) {
      points_.push_back(map_.vertices[e.to]);
      if (!descend(e.to, length + e.length)) return false;
      points_.pop_back();
    }
    return true;
  }

  const Roadmap& map_;
  int max_expansions_;
  const VisitPath& visit_;
  std::vector<double> to_go_;
  std::vector<Vector2> points_;
  int expanded_ = 0;
};

}  // namespace

int search_best_first(const Roadmap& map, const std::vector<Body>& bodies, const Course& course,
                      int max_expansions, const VisitPath& visit) {
  const std::vector<double> to_go = lengths_to_go(map);
  std::vector<RoutePoint> points;
  for (const Vector2& v : map.vertices) points.push_back({v, course.earliest_time(v)});

  std::vector<Partial> partials{{0, 0, 0.0, std::vector<int>(bodies.size(), 0)}};
  std::vector<std::vector<std::size_t>> expanded_at(map.vertices.size());  // one partial of each class
  using Entry = std::tuple<double, std::size_t>;  // length over the partial to the goal, partial
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  open.emplace(to_go.front(), 0);
  int expanded = 0;
  while (!open.empty() && expanded < max_expansions && std::isfinite(std::get<0>(open.top()))) {
    const std::size_t current = std::get<1>(open.top());
    open.pop();
    const std::size_t vertex = partials[current].vertex;
    const bool known =
        std::any_of(expanded_at[vertex].begin(), expanded_at[vertex].end(),
                    [&](std::size_t k) { return partials[k].crossings == partials[current].crossings; });
    if (known) continue;
    expanded_at[vertex].push_back(current);
    ++expanded;
    if (vertex == map.goal()) {
      if (!visit(points_of(partials, current, map), partials[current].length)) break;
      continue;
    }
    for (const RoadmapEdge& e : map.edges[vertex]) {
      Partial next{e.to, current, partials[current].length + e.length, partials[current].crossings};
      for (std::size_t b = 0; b < bodies.size(); ++b) {
        next.crossings[b] += cut_crossings(bodies[b], points[vertex], points[e.to]);
      }
      open.emplace(next.length + to_go[e.to], partials.size());
      partials.push_back(std::move(next));
    }
  }
  return expanded;
}

int search_depth_first(const Roadmap& map, int max_expansions, const VisitPath& visit) {
  return DepthFirst(map, max_expansions, visit).run();
}

}  // namespace bw::homotopy
