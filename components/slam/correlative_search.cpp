#include "components/slam/correlative_search.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bw::slam {
namespace {

constexpr std::size_t kMostPoints = 120;
constexpr double kDeciding = 8.0;   // [m] points that decide the step of the angle
constexpr double kAwayCost = 0.02;  // of the score, at the edge of the window

struct EndCell {
  int i = 0;
  int j = 0;
};

// Tries every `stride`-th step of a box about (x, y, t) [steps] and keeps the best.
class WindowSearch {
 public:
  WindowSearch(const SurfaceMap& map, std::span<const SurfacePoint> points, const Pose2& start,
               const SearchWindow& window)
      : map_(map), start_(start), step_(map.resolution()), turn_(map.resolution() / kDeciding) {
    nx_ = static_cast<int>(std::ceil(window.x / step_));
    ny_ = static_cast<int>(std::ceil(window.y / step_));
    nt_ = static_cast<int>(std::ceil(window.theta / turn_));
    const std::size_t stride = std::max<std::size_t>(1, points.size() / kMostPoints);
    for (std::size_t i = 0; i < points.size(); i += stride) points_.push_back(points[i].position());
  }

  void all(int stride) { box(0, 0, 0, nx_, ny_, nt_, stride); }
  void near_best(int reach) { box(best_x_, best_y_, best_t_, reach, reach, reach, 1); }

  Correlation best() const {
    return {
        {start_.x + best_x_ * step_, start_.y + best_y_ * step_, wrap_angle(start_.theta + best_t_ * turn_)},
        best_score_};
  }

 private:
  void box(int x0, int y0, int t0, int nx, int ny, int nt, int stride) {
    const double all = 255.0 * static_cast<double>(points_.size());
    std::vector<EndCell> cells(points_.size());
    // Multiples of the stride, so that the start itself is tried.
    const auto first = [stride](int n) { return n / stride * stride; };
    for (int t = t0 - first(nt); t <= t0 + nt; t += stride) {
      const Pose2 X{start_.x, start_.y, wrap_angle(start_.theta + t * turn_)};
      for (std::size_t i = 0; i < points_.size(); ++i) {
        const Vector2 p = X * points_[i];
        cells[i] = {static_cast<int>(std::floor(p.x() / step_)), static_cast<int>(std::floor(p.y() / step_))};
      }
      for (int y = y0 - first(ny); y <= y0 + ny; y += stride) {
        for (int x = x0 - first(nx); x <= x0 + nx; x += stride) {
          int sum = 0;
          for (const EndCell& cell : cells) sum += map_.likelihood_of_cell(cell.i + x, cell.j + y);
          const double score = static_cast<double>(sum) / all;
          const double value = score - kAwayCost * (share(x, nx_) + share(y, ny_) + share(t, nt_)) / 3.0;
          if (value <= best_value_) continue;
          best_value_ = value;
          best_score_ = score;
          best_x_ = x;
          best_y_ = y;
          best_t_ = t;
        }
      }
    }
  }
  static double share(int at, int of) {
    return of == 0 ? 0.0 : static_cast<double>(at * at) / static_cast<double>(of * of);
  }

  const SurfaceMap& map_;
  Pose2 start_;
  double step_;
  double turn_;
  int nx_ = 0;
  int ny_ = 0;
  int nt_ = 0;
  std::vector<Vector2> points_;
  double best_value_ = -1.0;
  double best_score_ = 0.0;
  int best_x_ = 0;
  int best_y_ = 0;
  int best_t_ = 0;
};

}  // namespace

Correlation correlate(const SurfaceMap& map, std::span<const SurfacePoint> points, const Pose2& start,
                      const SearchWindow& window) {
  Correlation none;
  none.X = start;
  if (points.empty()) return none;
  WindowSearch search(map, points, start, window);
  search.all(3);
  search.near_best(2);
  return search.best();
}

}  // namespace bw::slam
