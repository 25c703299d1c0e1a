// Planners alone through sets of scenes in which others move: T-MPC's corridor (`bench corridor`, protocols.md 8.15),
// DynaBARN's worlds (`bench dynabarn`, 8.16), flows and encounters (`bench flows`, 8.17). Without DDS.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "components/lab/bench/scene_drive.hpp"
#include "components/local_planner/planner_registry.hpp"

namespace bw {

/// What is asked of a planner's drives in a set.
struct SceneGate {
  double least_success = 0.0;        ///< share
  double most_stuck = 1.0;           ///< share of drives that do not pass in time
  bool no_robot_closing = false;     ///< no contact that the robot drove into (who_hit_whom.hpp)
  bool no_contact_at_speed = false;  ///< none while it moved faster than kStandingSpeed
};

/// What `drives` miss of `gate`, in words; empty: nothing.
std::string missed(const SceneGate& gate, const std::vector<SceneDrive>& drives);

struct SceneSet {
  std::string name;
  DriveScene
      empty;  ///< the same with nobody there, which each planner drives first, once for all sets whose empty scene has this name
  std::vector<DriveScene> scenes = {};
  std::optional<SceneGate> gate = {};
};

struct BenchScenesArguments {
  ScenePrediction prediction = ScenePrediction::constant_velocity;
  std::vector<std::string> planners = {"eteb"};
  std::function<void(PlannerOptions&)> adjust;  ///< last word on the options; may be empty
  bool check = false;                           ///< a gate that is missed makes the exit status 1
  int jobs = 1;      ///< drives at a time; above 1 the times are those of their threads
  std::string json;  ///< output file; empty: none
};

/// Prints a line for each drive, a table for each set and what it misses of its gate; writes JSON after each row. Returns the
/// exit status. Throws std::runtime_error on unusable names.
int bench_scenes(const std::vector<SceneSet>& sets, const BenchScenesArguments& arguments);

}  // namespace bw
