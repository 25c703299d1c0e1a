#include "components/slam/branch_and_bound.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bw::slam {
namespace {

constexpr double kDecidingRange = 10.0;  // [m] points that decide the step of the angle

struct Cells {
  double turn = 0.0;
  std::vector<int> i;
  std::vector<int> j;
};

struct Square {
  int sum = 0;
  int heading = 0;  // index
  int level = 0;
  int i = 0;  // moved by so many cells
  int j = 0;
};

class Search {
 public:
  Search(const MaxGrids& grids, std::span<const Vector2> points, const Pose2& start,
         const SearchWindow& window)
      : grids_(grids), nx_(cells(window.x)), ny_(cells(window.y)) {
    const double step = MaxGrids::kCell / kDecidingRange;
    const int n = static_cast<int>(std::ceil(window.theta / step));
    for (int t = -n; t <= n; ++t) {
      Cells at;
      at.turn = t * step;
      const Pose2 X{start.x, start.y, wrap_angle(start.theta + at.turn)};
      for (const Vector2& point : points) {
        const Vector2 p = X * point;
        at.i.push_back(static_cast<int>(std::floor(p.x() / MaxGrids::kCell)));
        at.j.push_back(static_cast<int>(std::floor(p.y() / MaxGrids::kCell)));
      }
      headings_.push_back(std::move(at));
    }
  }

  // Depth first, the better squares first; what cannot beat `best` is not opened.
  void run(Square& best) {
    int level = 0;
    while (level + 1 < MaxGrids::kLevels && (1 << (level + 1)) <= std::max(nx_, ny_)) ++level;
    std::vector<Square> roots;
    for (int h = 0; h < static_cast<int>(headings_.size()); ++h)
      for (int j = -ny_; j <= ny_; j += 1 << level)
        for (int i = -nx_; i <= nx_; i += 1 << level) add({0, h, level, i, j}, best.sum, roots);
    std::sort(roots.begin(), roots.end(), better);
    for (const Square& root : roots) {
      if (root.sum <= best.sum) break;
      open(root, best);
    }
  }

  std::int64_t visited() const { return visited_; }
  double turn(const Square& square) const { return headings_[static_cast<std::size_t>(square.heading)].turn; }

 private:
  static int cells(double metres) { return static_cast<int>(std::ceil(metres / MaxGrids::kCell)); }
  static bool better(const Square& a, const Square& b) { return a.sum > b.sum; }

  void add(Square square, int least, std::vector<Square>& to) {
    const Cells& at = headings_[static_cast<std::size_t>(square.heading)];
    for (std::size_t k = 0; k < at.i.size(); ++k)
      square.sum += grids_.at(square.level, at.i[k] + square.i, at.j[k] + square.j);
    ++visited_;
    if (square.sum > least) to.push_back(square);
  }

  void open(const Square& square, Square& best) {
    if (square.level == 0) {
      best = square;
      return;
    }
    const int half = 1 << (square.level - 1);
    std::vector<Square> parts;
    parts.reserve(4);
    for (int dj = 0; dj <= half; dj += half)
      for (int di = 0; di <= half; di += half)
        if (square.i + di <= nx_ && square.j + dj <= ny_)
          add({0, square.heading, square.level - 1, square.i + di, square.j + dj}, best.sum, parts);
    std::sort(parts.begin(), parts.end(), better);
    for (const Square& part : parts) {
      if (part.sum <= best.sum) break;
      open(part, best);
    }
  }

  const MaxGrids& grids_;
  int nx_;
  int ny_;
  std::vector<Cells> headings_;
  std::int64_t visited_ = 0;
};

}  // namespace

std::optional<Correlation> branch_and_bound(const MaxGrids& grids, std::span<const Vector2> points,
                                            const Pose2& start, const SearchWindow& window, double least,
                                            std::int64_t& visited) {
  if (points.empty()) return std::nullopt;
  const double all = 255.0 * static_cast<double>(points.size());
  Square best;
  best.sum = static_cast<int>(least * all);
  best.level = -1;
  Search search(grids, points, start, window);
  search.run(best);
  visited += search.visited();
  if (best.level < 0) return std::nullopt;
  return Correlation{{start.x + best.i * MaxGrids::kCell, start.y + best.j * MaxGrids::kCell,
                      wrap_angle(start.theta + search.turn(best))},
                     static_cast<double>(best.sum) / all};
}

}  // namespace bw::slam
