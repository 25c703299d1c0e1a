#include "components/lab/bench/course_world.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <stdexcept>
#include <utility>

#include "components/model/distance_transform.hpp"

namespace bw {
namespace {

constexpr double kStep = 0.025;        // [m]; every post of the lattice stands on a node
constexpr double kFieldStart = 2.175;  // x of the middle of the field's first row of cells [m]
constexpr double kRight = -2.175;      // y of the middle of the right side wall [m]

/// Distances to the posts on the nodes of a grid.
class Nodes {
 public:
  explicit Nodes(const std::vector<Disc>& posts) {
    grid_ = {.resolution = kStep, .origin = {-3.5, -2.5}, .width = 580, .height = 200};
    grid_.cells.assign(static_cast<std::size_t>(grid_.width) * static_cast<std::size_t>(grid_.height),
                       OccupancyGrid::kFree);
    for (const Disc& post : posts) {
      const int column = column_of(post.center.x());
      const int row = row_of(post.center.y());
      if (grid_.contains(column, row)) grid_.cells[grid_.index(column, row)] = OccupancyGrid::kOccupied;
    }
    distance_ = distance_field(grid_, {});
  }

  int column_of(double x) const { return static_cast<int>(std::lround((x - grid_.origin.x()) / kStep)); }
  int row_of(double y) const { return static_cast<int>(std::lround((y - grid_.origin.y()) / kStep)); }
  std::size_t node(double x, double y) const { return grid_.index(column_of(x), row_of(y)); }
  std::size_t size() const { return distance_.size(); }
  /// From a node to the surface of the nearest post.
  double clearance(std::size_t i) const { return static_cast<double>(distance_[i]) - kCoursePost; }

  /// Calls visit(neighbour, length [m]) for the 16 neighbours between the side walls.
  template <class Visit>
  void for_each_neighbour(std::size_t i, Visit&& visit) const {
    static constexpr std::array<std::pair<int, int>, 16> kSteps = {{{1, 0},
                                                                    {0, 1},
                                                                    {-1, 0},
                                                                    {0, -1},
                                                                    {1, 1},
                                                                    {-1, 1},
                                                                    {-1, -1},
                                                                    {1, -1},
                                                                    {2, 1},
                                                                    {1, 2},
                                                                    {-1, 2},
                                                                    {-2, 1},
                                                                    {-2, -1},
                                                                    {-1, -2},
                                                                    {1, -2},
                                                                    {2, -1}}};
    const int column = static_cast<int>(i % static_cast<std::size_t>(grid_.width));
    const int row = static_cast<int>(i / static_cast<std::size_t>(grid_.width));
    for (const auto& [dx, dy] : kSteps) {
      if (!grid_.contains(column + dx, row + dy)) continue;
      if (std::abs(grid_.origin.y() + (row + dy) * kStep) > -kRight) continue;
      visit(grid_.index(column + dx, row + dy), kStep * std::hypot(dx, dy));
    }
  }

 private:
  OccupancyGrid grid_;
  std::vector<float> distance_;
};

/// Dijkstra from `start`; `worse(key of a node, step to the next) -> key`, smaller keys first. Returns
/// predecessors.
template <class Next>
std::vector<std::size_t> search(const Nodes& nodes, std::size_t start, std::size_t goal, double first,
                                std::vector<double>& key, Next&& next) {
  using Entry = std::pair<double, std::size_t>;
  key.assign(nodes.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> before(nodes.size(), start);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  key[start] = first;
  open.emplace(first, start);
  while (!open.empty()) {
    const auto [value, i] = open.top();
    open.pop();
    if (i == goal) break;
    if (value > key[i]) continue;
    nodes.for_each_neighbour(i, [&](std::size_t n, double length) {
      const double then = next(value, n, length);
      if (!(then < key[n])) return;
      key[n] = then;
      before[n] = i;
      open.emplace(then, n);
    });
  }
  return before;
}

}  // namespace

Vector2 course_cell(int along, int across) {
  return {kFieldStart + along * kCourseCell, kRight + across * kCourseCell};
}

CourseMeasures measure(const CourseWorld& world) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  CourseMeasures m;
  const auto in_field = [](const Disc& post) {
    const double half = kCourseCell / 2.0;
    return post.center.x() > kFieldStart - half &&
           post.center.x() < kFieldStart + kCourseSide * kCourseCell - half;
  };
  m.filled = static_cast<double>(std::count_if(world.posts.begin(), world.posts.end(), in_field)) /
             (kCourseSide * kCourseSide);
  const Nodes nodes(world.posts);
  const std::size_t start = nodes.node(0.0, 0.0);
  const std::size_t goal = nodes.node(kCourseLength, 0.0);
  std::vector<double> key;
  search(nodes, start, goal, -nodes.clearance(start), key,
         [&](double value, std::size_t n, double) { return std::max(value, -nodes.clearance(n)); });
  m.narrowest = -key[goal];
  const std::vector<std::size_t> before =
      search(nodes, start, goal, 0.0, key, [&](double value, std::size_t n, double length) {
        return nodes.clearance(n) < kCourseInscribed ? kNever : value + length;
      });
  if (!(key[goal] < kNever)) return m;
  m.path_length = key[goal];
  int count = 0;
  for (std::size_t i = goal;; i = before[i]) {
    m.clearance += nodes.clearance(i);
    ++count;
    if (i == start) break;
  }
  m.clearance /= count;
  return m;
}

bool CourseRanges::contain(const CourseMeasures& m) const {
  const auto within = [&](double CourseMeasures::*measure) {
    return m.*measure >= least.*measure && m.*measure <= most.*measure;
  };
  return m.path_length > 0.0 && within(&CourseMeasures::filled) && within(&CourseMeasures::clearance) &&
         within(&CourseMeasures::narrowest);
}

CourseRanges ranges_of(const std::vector<CourseMeasures>& measures) {
  if (measures.empty()) throw std::invalid_argument("no course to take ranges from");
  CourseRanges ranges{measures.front(), measures.front()};
  for (const CourseMeasures& m : measures) {
    for (const auto measure : {&CourseMeasures::filled, &CourseMeasures::path_length,
                               &CourseMeasures::clearance, &CourseMeasures::narrowest}) {
      ranges.least.*measure = std::min(ranges.least.*measure, m.*measure);
      ranges.most.*measure = std::max(ranges.most.*measure, m.*measure);
    }
  }
  return ranges;
}

}  // namespace bw
