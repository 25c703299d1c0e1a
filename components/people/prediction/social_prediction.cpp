#include "components/people/prediction/social_prediction.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "components/model/nearest_point.hpp"

namespace bw::people {
namespace {

constexpr double kSubstep = 0.1;       // [s], at most
constexpr double kReachOfWalls = 3.0;  // [m]: farther, their push is nothing

struct Walker {
  Vector2 position;
  Vector2 velocity;
  Vector2 desired;
  double radius;
};

std::optional<Vector2> nearest_wall_point(const StaticObstacles& walls, const Vector2& from) {
  double best = std::numeric_limits<double>::infinity();
  Vector2 nearest(0.0, 0.0);
  const auto consider = [&](const Vector2& point) {
    if (const double d = (point - from).squaredNorm(); d < best) {
      best = d;
      nearest = point;
    }
  };
  for (const Vector2& point : walls.points) consider(point);
  for (const Disc& disc : walls.discs) {
    if ((from - disc.center).norm() > disc.radius) consider(nearest_point(disc, from));
  }
  for (const Segment& segment : walls.segments) consider(nearest_point(segment, from));
  return std::isfinite(best) ? std::optional(nearest) : std::nullopt;
}

void advance(std::vector<Walker>& walkers, const StaticObstacles& walls, const PredictionOptions& options,
             double dt) {
  std::vector<Vector2> forces(walkers.size(), Vector2(0.0, 0.0));
  for (std::size_t i = 0; i < walkers.size(); ++i) {
    const Walker& walker = walkers[i];
    if (walker.desired.norm() < options.kWalkingSpeed) continue;  // who stands is not pushed about
    forces[i] = desired_force(options.forces, walker.desired, walker.velocity);
    for (std::size_t j = 0; j < walkers.size(); ++j) {
      if (j == i) continue;
      forces[i] += social_force(options.forces, walkers[j].position - walker.position,
                                walker.velocity - walkers[j].velocity);
    }
    const std::optional<Vector2> nearest = nearest_wall_point(walls, walker.position);
    if (nearest && (walker.position - *nearest).norm() < kReachOfWalls)
      forces[i] += obstacle_force(options.forces, walker.position - *nearest, walker.radius);
  }
  for (std::size_t i = 0; i < walkers.size(); ++i) {
    Walker& walker = walkers[i];
    walker.velocity += dt * forces[i];
    const double most = 1.3 * walker.desired.norm();
    if (const double speed = walker.velocity.norm(); speed > most) walker.velocity *= most / speed;
    walker.position += dt * walker.velocity;
  }
}

}  // namespace

std::vector<std::vector<Vector2>> walk_on(const std::vector<TrackedPerson>& people,
                                          const StaticObstacles& walls, const PredictionOptions& options) {
  std::vector<Walker> walkers;
  walkers.reserve(people.size());
  for (const TrackedPerson& p : people) walkers.push_back({p.position, p.velocity, p.velocity, p.radius});
  const int steps = static_cast<int>(std::floor(options.horizon / options.step + 1e-9));
  const int substeps = static_cast<int>(std::ceil(options.step / kSubstep - 1e-9));
  std::vector<std::vector<Vector2>> positions;
  for (int k = 0; k < steps; ++k) {
    for (int n = 0; n < substeps; ++n) advance(walkers, walls, options, options.step / substeps);
    std::vector<Vector2>& now = positions.emplace_back();
    for (const Walker& walker : walkers) now.push_back(walker.position);
  }
  return positions;
}

}  // namespace bw::people
