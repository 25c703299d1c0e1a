// Several robots on one floor, each with a planner of its own: what happens, without DDS and without noise.
#pragma once

#include <memory>
#include <vector>

#include "components/model/planning.hpp"

namespace bw {

/// One robot and its errand.
struct FloorRobot {
  std::unique_ptr<LocalPlanner> planner;
  bool runs_hrvo = false;  ///< two robots that do know it of each other (D7)
  Pose2 pose;
  Pose2 goal;
  Twist2 twist;
};

struct FloorRules {
  Limits limits;
  double radius = 0.3;                   ///< of every robot [m]
  double control_period = 0.25;          ///< commands are held that long [s]
  int steps_per_period = 10;             ///< tests for contact within it
  double goal_radius = 0.3;              ///< the run ends when the first robot is this near to its goal [m]
  double view_range = 8.0;               ///< a robot sees others up to here [m]
  double view_angle = 4.71238898038469;  ///< centred on its heading [rad]
  double timeout = 60.0;                 ///< [s]
};

/// The run at one control instant.
struct FloorSample {
  double time = 0.0;                    ///< [s]
  double v = 0.0;                       ///< of the first robot: command from here on [m/s]
  double gap = 0.0;                     ///< from it to the nearest other robot, between outlines [m]
  std::vector<Vector2> positions = {};  ///< of all robots, the first one first
};

enum class FloorOutcome { reached, contact, timeout };

struct FloorRun {
  FloorOutcome outcome = FloorOutcome::timeout;
  double time = 0.0;                ///< when the run ended [s]
  double mean_speed = 0.0;          ///< of the first robot, time mean until then [m/s]
  double smallest_gap = 0.0;        ///< [m]; negative on contact
  double smallest_other_gap = 0.0;  ///< between two others [m]; infinite with fewer than two
  int not_ok = 0;                   ///< cycles in which the first robot's planner found nothing admissible
  std::vector<FloorSample> samples;
};

/// All robots plan from the same instant, then all move. Exact poses and velocities are known to everybody in
/// view. Ends when the first robot reaches its goal or touches another one, or at the timeout.
FloorRun run_on_floor(std::vector<FloorRobot> robots, const FloorRules& rules);

}  // namespace bw
