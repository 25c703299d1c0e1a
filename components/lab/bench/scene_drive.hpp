// One planner alone through a scene in which others move, as published protocols have them. Deterministic but for the
// times. Metres, seconds.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "components/evaluation/judged_contact.hpp"
#include "components/evaluation/success.hpp"
#include "components/lab/bench/bench_common.hpp"
#include "components/lab/bench/drive_rates.hpp"
#include "components/model/planning.hpp"

namespace bw {

/// The robot, as those see it who go round it.
struct SceneRobot {
  Vector2 position{0.0, 0.0};
  Vector2 velocity{0.0, 0.0};
};

struct SceneDisc {
  std::uint32_t id = 0;  ///< another one after a jump
  Vector2 position{0.0, 0.0};
  Vector2 velocity{0.0, 0.0};
  double radius = 0.3;
};

inline constexpr double kSceneStep = 0.05;  ///< [s] of everybody, and between plans

/// As whoever follows a path is judged (components/model/progress_checker.hpp): half a metre within so long [s].
inline constexpr double kBlockedTime = 5.0;

/// Who moves about.
class SceneMovers {
 public:
  virtual ~SceneMovers() = default;
  virtual std::unique_ptr<SceneMovers> clone() const = 0;
  virtual const std::vector<SceneDisc>& discs() const = 0;
  /// All of them kSceneStep on.
  virtual void step(const SceneRobot& robot) = 0;
};

/// What planners are told of where the others will be.
enum class ScenePrediction {
  constant_velocity,
  roll_out  ///< by their own rule, with a robot that stands where it started
};
const char* to_text(ScenePrediction prediction);

struct DriveScene {
  std::string name;
  Pose2 start;
  std::shared_ptr<const SceneMovers> movers;
  StaticObstacles walls;     ///< that the planner sees
  bool walls_count = false;  ///< a contact with them is one; false: they are told, not counted
  Limits limits;
  double robot_radius = 0.3;
  double timeout = 30.0;
  double unscored = 0.0;  ///< at the start, in which a contact does not count
  /// No way leads on: who made no progress for kBlockedTime is told so, and has passed.
  bool is_blocked = false;
  std::function<bool(const Pose2&)> is_done;
  std::function<std::vector<Pose2>(const Pose2&)> path;  ///< that the planner is given
  bool goal_is_final = false;                            ///< the path ends where the drive does
};

struct SceneDrive {
  std::string name;
  bool passed = false;      ///< in time
  double duration = 0.0;    ///< [s] until then, or the timeout
  int contacts = 0;         ///< that count
  bool wall = false;        ///< one of them with a wall
  int sudden_contacts = 0;  ///< of these, with who came to be less than a second before
  int infeasible = 0;       ///< cycles in which the planner found no way
  double path = 0.0;        ///< [m]
  double min_gap = std::numeric_limits<double>::infinity();   ///< [m] between outlines
  double min_wall = std::numeric_limits<double>::infinity();  ///< [m] from the robot's outline to the walls
  double rms_jerk = 0.0;                                      ///< [m/s^3]
  std::vector<double> ms;                                     ///< CPU time of every cycle
  std::vector<JudgedContact> judged;

  bool success() const { return is_success(passed, contacts); }
};

/// Every kSceneStep the planner gets true positions and velocities. Contacts are those of the straight ways between
/// steps. `planner` should be new.
SceneDrive drive_scene(const DriveScene& scene, ScenePrediction prediction, LocalPlanner& planner,
                       const CpuClock& clock);

std::vector<RatedDrive> rated(const std::vector<SceneDrive>& drives);
nlohmann::ordered_json to_json(const std::vector<SceneDrive>& drives);
std::string in_a_line(const SceneDrive& drive);

}  // namespace bw
