// Random paths that cross, fold back over themselves and close, and whether a drive passed positions of a
// path in their order.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "components/model/random.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

/// Straight from corner to corner, a pose each 5 cm; headings are 0 as NavFn leaves them, but the last, which
/// is that of the path.
inline std::vector<Pose2> path_over(const std::vector<Vector2>& corners) {
  std::vector<Pose2> path;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Vector2 leg = corners[i] - corners[i - 1];
    const int pieces = static_cast<int>(std::ceil(leg.norm() / 0.05));
    for (int k = 0; k < pieces; ++k) {
      const Vector2 p = corners[i - 1] + leg * k / pieces;
      path.push_back({p.x(), p.y(), 0.0});
    }
  }
  const Vector2 last = corners.back() - corners[corners.size() - 2];
  path.push_back({corners.back().x(), corners.back().y(), std::atan2(last.y(), last.x())});
  return path;
}

/// Corners of a path from (0, 0): stretches of 0.6 to 4 m, each third one back over the one before, any turn
/// else; each third path comes back to where it began.
inline std::vector<Vector2> random_corners(Random& random) {
  std::vector<Vector2> corners = {{0.0, 0.0}};
  double heading = 0.0;
  const int count = 3 + static_cast<int>(random.uniform(0.0, 5.0));
  for (int i = 0; i < count; ++i) {
    const bool folds = i > 0 && random.uniform() < 1.0 / 3.0;
    heading += folds ? std::numbers::pi : i == 0 ? 0.0 : random.uniform(-2.6, 2.6);
    const double length = random.uniform(0.6, 4.0);
    corners.push_back(corners.back() + length * direction(heading));
  }
  const bool closes = random.uniform() < 1.0 / 3.0 && corners.back().norm() > 0.6;
  if (closes) corners.push_back({0.0, 0.0});
  return corners;
}

/// Of `wanted`, how many the robot passed within `tolerance`, each after the one before.
inline std::size_t passed_in_order(const std::vector<Vector2>& wanted, const std::vector<Pose2>& driven,
                                   double tolerance) {
  std::size_t passed = 0;
  for (const Pose2& X : driven) {
    while (passed < wanted.size() && (X.position() - wanted[passed]).norm() <= tolerance) ++passed;
  }
  return passed;
}

/// Positions each 0.5 m along a path of path_over(), and its end.
inline std::vector<Vector2> positions_of(const std::vector<Pose2>& path) {
  std::vector<Vector2> positions;
  for (std::size_t i = 0; i < path.size(); i += 10) positions.push_back(path[i].position());
  positions.push_back(path.back().position());
  return positions;
}

}  // namespace bw
