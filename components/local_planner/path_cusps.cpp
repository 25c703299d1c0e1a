#include "components/local_planner/path_cusps.hpp"

#include <algorithm>
#include <cmath>

namespace bw {
namespace {

// Directions are those over this length, since paths of grids go in steps of a cell, and recorded ones tremble [m].
constexpr double kScale = 0.25;
constexpr double kShortest = 0.05;   // [m] of a way that has a direction
constexpr double kCuspAngle = 1.05;  // [rad]

/// How far the path leads to and from a place where it turns [m]; 0: it does not. It is greatest at the very corner.
double tip_length(const PlanLine& line, double along) {
  const Vector2 here = line.at(along);
  const Vector2 in = here - line.at(along - kScale);
  const Vector2 out = line.at(along + kScale) - here;
  if (in.norm() < kShortest || out.norm() < kShortest) return 0.0;
  const double angle = std::abs(std::atan2(cross(in, out), in.dot(out)));
  return angle > kCuspAngle ? in.norm() + out.norm() : 0.0;
}

}  // namespace

std::vector<std::size_t> cusps_of(const std::vector<Pose2>& poses, const std::vector<double>& along,
                                  const PlanLine& line) {
  std::vector<std::size_t> cusps;
  double longest = 0.0;  // tip of the last cusp
  for (std::size_t i = 1; i + 1 < poses.size(); ++i) {
    if (along[i] < kScale || along.back() - along[i] < kScale) continue;
    const double length = tip_length(line, along[i]);
    if (length == 0.0) continue;
    if (!cusps.empty() && along[i] - along[cusps.back()] < kScale) {
      if (length <= longest + 1e-9) continue;
      cusps.pop_back();
    }
    cusps.push_back(i);
    longest = length;
  }
  return cusps;
}

}  // namespace bw
