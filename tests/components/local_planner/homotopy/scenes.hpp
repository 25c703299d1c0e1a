// Small scenes shared by the tests of topologies.
#pragma once

#include <vector>

#include "components/local_planner/homotopy/obstacle_bodies.hpp"
#include "components/model/random.hpp"

namespace bw::homotopy {

/// From (0, 0) to (10, 0) at 1 m/s; robot radius 0.3 m, wanted gap 0.2 m.
inline Course ten_metres() { return {{0.0, 0.0}, {10.0, 0.0}, 0.3, 0.2, 1.0}; }

inline Body standing(const Vector2& centre, double radius) {
  return {{{{centre, centre}, radius}}, centre, std::nullopt, std::nullopt};
}

inline Mover mover_at(const Vector2& position, const Vector2& velocity) {
  Mover mover;
  mover.position = position;
  mover.velocity = velocity;
  return mover;
}

/// `count` positions between (1, -2) and (9, 2), at least `separation` [m] apart.
inline std::vector<Vector2> separated(Random& random, std::size_t count, double separation) {
  std::vector<Vector2> positions;
  while (positions.size() < count) {
    const Vector2 p{random.uniform(1.0, 9.0), random.uniform(-2.0, 2.0)};
    bool apart = true;
    for (const Vector2& q : positions) apart = apart && (p - q).norm() >= separation;
    if (apart) positions.push_back(p);
  }
  return positions;
}

}  // namespace bw::homotopy
