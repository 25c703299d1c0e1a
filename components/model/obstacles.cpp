#include "components/model/obstacles.hpp"

namespace bw {

Vector2 Mover::position_at(double t) const {
  double t0 = 0.0;
  Vector2 p0 = position;
  Vector2 velocity_after = velocity;
  for (const PredictedPosition& next : predictions) {
    if (next.time <= t0) continue;
    velocity_after = (next.position - p0) / (next.time - t0);
    if (t <= next.time) break;
    t0 = next.time;
    p0 = next.position;
  }
  return p0 + velocity_after * (t - t0);
}

}  // namespace bw
