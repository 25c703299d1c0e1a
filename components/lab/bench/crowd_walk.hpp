// Where a walker of a crowd scene is: constant speed, mirrored at the walls of the box.
#pragma once

#include "components/lab/bench/scene_file.hpp"

namespace bw {

/// At `time` [s] after the scene began. Static discs stay where they are, even outside the box.
Vector2 position_at(const SceneObstacle& obstacle, const SceneBox& box, double time);
Vector2 velocity_at(const SceneObstacle& obstacle, const SceneBox& box, double time);

}  // namespace bw
