#include "components/local_planner/homotopy/clusters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <tuple>

#include "components/local_planner/homotopy/segment_distance.hpp"

namespace bw::homotopy {
namespace {

constexpr double kSmallestCell = 1e-3;  // [m]
constexpr double kRounding = 1e-9;      // [m]

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  bool joined(std::size_t i, std::size_t k) { return root(i) == root(k); }
  // The smaller index stays the root, so that clusters keep the order of their first parts.
  void join(std::size_t i, std::size_t k) {
    const std::size_t a = root(i);
    const std::size_t b = root(k);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

bool before(const Vector2& l, const Vector2& r) {
  return std::make_tuple(l.x(), l.y()) < std::make_tuple(r.x(), r.y());
}

bool part_before(const Part& l, const Part& r) {
  if (l.axis.a.x() != r.axis.a.x()) return l.axis.a.x() < r.axis.a.x();  // nearly always: no tuple
  const auto key = [](const Part& p) {
    return std::make_tuple(p.axis.a.y(), p.axis.b.x(), p.axis.b.y(), p.radius);
  };
  return key(l) < key(r);
}

// Points first, each kind sorted.
std::vector<Part> sorted_parts(const StaticObstacles& obstacles) {
  std::vector<Part> parts;
  parts.reserve(obstacles.size());
  for (const Vector2& p : obstacles.points) parts.push_back({{p, p}, 0.0});
  for (const Disc& d : obstacles.discs) parts.push_back({{d.center, d.center}, d.radius});
  for (const Segment& s : obstacles.segments) {
    parts.push_back({before(s.b, s.a) ? Segment{s.b, s.a} : s, 0.0});
  }
  const auto others = parts.begin() + static_cast<std::ptrdiff_t>(obstacles.points.size());
  std::sort(parts.begin(), others, part_before);
  std::sort(others, parts.end(), part_before);
  return parts;
}

struct Cell {
  std::int64_t row, column;
  std::size_t first, last;  // into the list of points by cell
  auto index() const { return std::make_tuple(row, column); }
};

// Points of one cell are within the gap of each other by its size; only then neighbours up to two cells away
// are looked at, one link being enough for a pair of cells.
void join_points(const std::vector<Part>& parts, std::size_t count, double widest_gap, DisjointSets& sets) {
  const double size = std::max(widest_gap / std::numbers::sqrt2, kSmallestCell);
  std::vector<std::array<std::int64_t, 3>> placed(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2& p = parts[i].axis.a;
    placed[i] = {static_cast<std::int64_t>(std::floor(p.y() / size)),
                 static_cast<std::int64_t>(std::floor(p.x() / size)), static_cast<std::int64_t>(i)};
  }
  std::sort(placed.begin(), placed.end());
  const auto point = [&](std::size_t k) { return static_cast<std::size_t>(placed[k][2]); };
  const double limit = widest_gap * widest_gap;
  const auto near = [&](std::size_t k, std::size_t m) {
    return (parts[point(k)].axis.a - parts[point(m)].axis.a).squaredNorm() <= limit;
  };
  std::vector<Cell> cells;
  for (std::size_t k = 0; k < count; ++k) {
    if (!cells.empty() && cells.back().index() == std::make_tuple(placed[k][0], placed[k][1])) {
      cells.back().last = k + 1;
      if (near(cells.back().first, k)) sets.join(point(cells.back().first), point(k));
    } else {
      cells.push_back({placed[k][0], placed[k][1], k, k + 1});
    }
  }
  const auto join_cells = [&](const Cell& c, const Cell& d) {
    if (sets.joined(point(c.first), point(d.first))) return;
    for (std::size_t k = c.first; k < c.last; ++k) {
      for (std::size_t m = d.first; m < d.last; ++m) {
        if (near(k, m)) return sets.join(point(k), point(m));
      }
    }
  };
  for (std::int64_t up = 0; up <= 2; ++up) {
    std::size_t from = 0;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto [row, column] = cells[c].index();
      while (from < cells.size() && cells[from].index() < std::make_tuple(row + up, column - 2)) ++from;
      for (std::size_t d = up == 0 ? c + 1 : from; d < cells.size(); ++d) {
        if (cells[d].index() > std::make_tuple(row + up, column + 2)) break;
        join_cells(cells[c], cells[d]);
      }
    }
  }
}

// Discs and segments, which come after `points` points, with whatever is near.
void join_others(const std::vector<Part>& parts, std::size_t points, double widest_gap, DisjointSets& sets) {
  if (points == parts.size()) return;
  const CapsuleIndex index(capsules_of(parts));
  for (std::size_t i = points; i < parts.size(); ++i) {
    const Segment& axis = parts[i].axis;
    const double reach_of_axis = 0.5 * (axis.b - axis.a).norm() + widest_gap + parts[i].radius + kRounding;
    index.visit_near(0.5 * (axis.a + axis.b), reach_of_axis, [&](const CapsuleIndex::Group& group) {
      for (const std::uint32_t k : index.members(group)) {
        if (k == i || sets.joined(i, k)) continue;
        const double reach = widest_gap + parts[i].radius + parts[k].radius;
        if (squared_distance(axis, parts[k].axis) <= reach * reach) sets.join(i, k);
      }
    });
  }
}

}  // namespace

std::vector<Capsule> capsules_of(const std::vector<Part>& parts) {
  std::vector<Capsule> capsules;
  capsules.reserve(parts.size());
  for (const Part& part : parts) capsules.push_back({part.axis.a, part.axis.b, part.radius});
  return capsules;
}

std::vector<std::vector<Part>> clusters_of(const StaticObstacles& obstacles, double widest_gap) {
  const std::vector<Part> parts = sorted_parts(obstacles);
  DisjointSets sets(parts.size());
  join_points(parts, obstacles.points.size(), widest_gap, sets);
  join_others(parts, obstacles.points.size(), widest_gap, sets);
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> cluster_of_root(parts.size(), kNone);
  std::vector<std::vector<Part>> clusters;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::size_t& cluster = cluster_of_root[sets.root(i)];
    if (cluster == kNone) {
      cluster = clusters.size();
      clusters.emplace_back();
    }
    clusters[cluster].push_back(parts[i]);
  }
  return clusters;
}

}  // namespace bw::homotopy
