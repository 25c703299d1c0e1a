// People who walk on as they like, round one another and along walls: the forces of world/README.md 7.6,
// integrated.
#pragma once

#include <vector>

#include "components/people/prediction/predictor.hpp"

namespace bw::people {

/// Positions of everybody at step, 2 step, ...: result[k][i] is person i at (k + 1) step.
std::vector<std::vector<Vector2>> walk_on(const std::vector<TrackedPerson>& people,
                                          const StaticObstacles& walls, const PredictionOptions& options);

}  // namespace bw::people
