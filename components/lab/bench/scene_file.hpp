// Planner benchmark scenes, read from YAML in the format of teb_scenes.yaml and teb_crowd_scenes.yaml.
// Metres, seconds, radians.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "components/model/limits.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

/// A disc (a point when r = 0) that moves with constant velocity from t = 0.
struct SceneObstacle {
  Vector2 position{0.0, 0.0};
  double radius = 0.0;
  Vector2 velocity{0.0, 0.0};

  bool moves() const { return velocity.squaredNorm() > 0.0; }
};

struct Scene {
  std::string name;
  Pose2 start;
  Pose2 goal;
  std::vector<SceneObstacle> obstacles;
};

struct SceneWeights {
  double max_vel_x = 0, max_vel_theta = 0, acc_lim_x = 0, acc_lim_theta = 0, kinematics_nh = 0,
         forward_drive = 0;
  double time = 0, obstacle = 0, inflation = 0, dynamic_obstacle = 0, dynamic_inflation = 0,
         penalty_epsilon = 0;
};

/// Walls that mirror walkers.
struct SceneBox {
  double x_min = 0, x_max = 0, y_min = 0, y_max = 0;
};

/// How walkers walk; only that they move is in a file.
enum class WalkersManner {
  straight,  ///< on with their velocity, mirrored at the box; they see nobody
  social,    ///< by social forces, to and fro; they see each other and the robot
  orca       ///< by ORCA, likewise
};

/// "straight".
std::string_view text_of(WalkersManner walkers);

/// What closed-loop scenes have beside the open-loop ones.
struct ClosedLoop {
  double control_period = 0, timeout = 0, goal_tolerance = 0, robot_radius = 0;
  SceneBox box;
  WalkersManner walkers = WalkersManner::straight;
};

struct SceneFile {
  double replan_period = 0.0;
  int warm_cycles = 0;
  Limits limits;
  double dt_ref = 0, dt_hysteresis = 0;
  double min_dist = 0, inflation_dist = 0, dynamic_inflation_dist = 0;
  SceneWeights weights;
  std::optional<ClosedLoop> closed_loop;
  std::vector<Scene> scenes;
};

/// Throws std::runtime_error with file, line, key and rule when the file cannot be read, a key is missing or
/// unknown, or a number is not finite or out of its range.
SceneFile read_scene_file(const std::string& path);

}  // namespace bw
