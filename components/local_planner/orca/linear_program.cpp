#include "components/local_planner/orca/linear_program.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace bw::orca {
namespace {

constexpr double kParallel = 1e-5;  // sine below which two lines do not meet

using HalfPlanes = std::span<const HalfPlane>;

// What to come as near to as possible.
struct Aim {
  Vector2 velocity;
  bool is_direction;  ///< as far along it (a unit vector) as possible
};

// On the line of `line` and within all half planes `before`: the best velocity, if there is one.
std::optional<Vector2> best_on_line(const HalfPlane& line, HalfPlanes before, double v_max, const Aim& aim) {
  const double middle = -line.point.dot(line.direction);  // of the chord that the circle of v_max cuts out
  const double half_chord2 = middle * middle + v_max * v_max - line.point.squaredNorm();
  if (half_chord2 < 0.0) return std::nullopt;
  double low = middle - std::sqrt(half_chord2);
  double high = middle + std::sqrt(half_chord2);
  for (const HalfPlane& other : before) {
    const double sine = cross(line.direction, other.direction);
    const double outside = cross(other.direction, line.point - other.point);
    if (std::abs(sine) <= kParallel) {
      if (outside < 0.0) return std::nullopt;
      continue;
    }
    (sine > 0.0 ? high : low) = sine > 0.0 ? std::min(high, outside / sine) : std::max(low, outside / sine);
    if (low > high) return std::nullopt;
  }
  double t = std::clamp(line.direction.dot(aim.velocity - line.point), low, high);
  if (aim.is_direction) t = line.direction.dot(aim.velocity) > 0.0 ? high : low;
  return line.point + t * line.direction;
}

struct Progress {
  Vector2 velocity;
  std::size_t failed_at;  ///< the half plane that nothing within those before it fulfils; their number: none
};

Progress within_all(HalfPlanes half_planes, double v_max, const Aim& aim) {
  Progress progress{aim.velocity, half_planes.size()};
  const double speed = aim.velocity.norm();
  if (aim.is_direction || speed > v_max) progress.velocity *= aim.is_direction ? v_max : v_max / speed;
  for (std::size_t i = 0; i < half_planes.size(); ++i) {
    if (violation(half_planes[i], progress.velocity) <= 0.0) continue;
    const std::optional<Vector2> better = best_on_line(half_planes[i], half_planes.first(i), v_max, aim);
    if (!better) {
      progress.failed_at = i;
      return progress;
    }
    progress.velocity = *better;
  }
  return progress;
}

// Where `other` is violated no more than `line`: `line` is the one with the greatest violation there. Nothing
// when both are the same but for their position.
std::optional<HalfPlane> no_worse_than(const HalfPlane& line, const HalfPlane& other) {
  const double sine = cross(line.direction, other.direction);
  HalfPlane border;
  if (std::abs(sine) <= kParallel) {
    if (line.direction.dot(other.direction) > 0.0) return std::nullopt;
    border.point = 0.5 * (line.point + other.point);
  } else {
    border.point = line.point + (cross(other.direction, line.point - other.point) / sine) * line.direction;
  }
  border.direction = (other.direction - line.direction).normalized();
  return border;
}

// From a velocity within the half planes before `failed_at`: the greatest violation grows half plane by half
// plane, each time as little as can be.
Vector2 least_violation(HalfPlanes half_planes, std::size_t walls, const Progress& progress, double v_max) {
  Vector2 velocity = progress.velocity;
  double greatest = 0.0;
  for (std::size_t i = std::max(progress.failed_at, walls); i < half_planes.size(); ++i) {
    const HalfPlane& line = half_planes[i];
    if (violation(line, velocity) <= greatest) continue;
    std::vector<HalfPlane> borders(half_planes.begin(),
                                   half_planes.begin() + static_cast<std::ptrdiff_t>(walls));
    for (const HalfPlane& other : half_planes.subspan(walls, i - walls)) {
      if (const std::optional<HalfPlane> border = no_worse_than(line, other)) borders.push_back(*border);
    }
    const Vector2 inward{-line.direction.y(), line.direction.x()};
    // It fails by rounding alone: where the velocity is now is such a position.
    const Progress found = within_all(borders, v_max, {inward, true});
    if (found.failed_at == borders.size()) velocity = found.velocity;
    greatest = violation(line, velocity);
  }
  return velocity;
}

}  // namespace

Choice best_velocity(const std::vector<HalfPlane>& half_planes, std::size_t walls, const Vector2& wanted,
                     double v_max) {
  const Progress progress = within_all(half_planes, v_max, {wanted, false});
  if (progress.failed_at == half_planes.size()) return {progress.velocity, true};
  return {least_violation(half_planes, walls, progress, v_max), false};
}

}  // namespace bw::orca
