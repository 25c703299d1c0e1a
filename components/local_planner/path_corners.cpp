#include "components/local_planner/path_corners.hpp"

#include <cmath>

namespace bw {
namespace {

// Directions are those over this length, since paths on grids go in steps of a cell, and recorded ones
// tremble [m].
constexpr double kScale = 0.25;
constexpr double kShortest = 0.05;  // [m] of a path that has a direction
constexpr double kSharp = 1.4;      // [rad]

/// How far the path leads to and from a sharp corner `along` [m] it, in straight lines [m]; 0: there is none.
/// Of positions near a corner this is greatest at the corner itself.
double corner_length(const PlanLine& line, double along) {
  const Vector2 here = line.at(along);
  const Vector2 in = here - line.at(along - kScale);
  const Vector2 out = line.at(along + kScale) - here;
  if (in.norm() < kShortest || out.norm() < kShortest) return 0.0;
  const double angle = std::abs(std::atan2(cross(in, out), in.dot(out)));
  return angle > kSharp ? in.norm() + out.norm() : 0.0;
}

}  // namespace

std::vector<std::size_t> sharp_corners(const std::vector<Pose2>& poses, const std::vector<double>& along,
                                       const PlanLine& line) {
  std::vector<std::size_t> corners;
  double longest = 0.0;  // of the last corner
  for (std::size_t i = 1; i + 1 < poses.size(); ++i) {
    if (along[i] < kScale || along.back() - along[i] < kScale) continue;
    const double length = corner_length(line, along[i]);
    if (length == 0.0) continue;
    if (!corners.empty() && along[i] - along[corners.back()] < kScale) {
      if (length <= longest + 1e-9) continue;
      corners.pop_back();
    }
    corners.push_back(i);
    longest = length;
  }
  return corners;
}

}  // namespace bw
