#include "components/lab/bench/crowd_walk.hpp"

#include <cmath>

namespace bw {
namespace {

struct Folded {
  double position = 0.0;
  double direction = 1.0;  // -1 on the way back
};

Folded fold(double x, double low, double high) {
  const double span = high - low;
  double r = std::fmod(x - low, 2.0 * span);
  if (r < 0.0) r += 2.0 * span;
  if (r <= span) return {low + r, 1.0};
  return {low + 2.0 * span - r, -1.0};
}

}  // namespace

Vector2 position_at(const SceneObstacle& obstacle, const SceneBox& box, double time) {
  if (!obstacle.moves()) return obstacle.position;
  const Vector2 p = obstacle.position + time * obstacle.velocity;
  return {fold(p.x(), box.x_min, box.x_max).position, fold(p.y(), box.y_min, box.y_max).position};
}

Vector2 velocity_at(const SceneObstacle& obstacle, const SceneBox& box, double time) {
  const Vector2 p = obstacle.position + time * obstacle.velocity;
  return {obstacle.velocity.x() * fold(p.x(), box.x_min, box.x_max).direction,
          obstacle.velocity.y() * fold(p.y(), box.y_min, box.y_max).direction};
}

}  // namespace bw
