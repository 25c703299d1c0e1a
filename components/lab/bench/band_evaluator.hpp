// One judge for every planner's band: costs, limit excess and clearance by the rules of the benchmark scenes.
// Written apart from the planner's residuals, so that each checks the other.
#pragma once

#include <vector>

#include "components/lab/bench/scene_file.hpp"
#include "components/model/planning.hpp"

namespace bw {

/// Pose and the time [s] to the next one (last: 0).
struct EvaluatedPose {
  Pose2 pose;
  double dt = 0.0;
};

struct BandCosts {
  double time = 0, nonholonomic = 0, velocity = 0, acceleration = 0, obstacle = 0;
  double total() const { return time + nonholonomic + velocity + acceleration + obstacle; }
};

struct BandQuality {
  double time = 0.0;              ///< [s]
  double max_nonholonomic = 0.0;  ///< [m]
  double excess_v = 0, excess_omega = 0, excess_a = 0, excess_alpha = 0;
  double clearance_poses = 0.0;     ///< [m] from the centre of the robot
  double clearance_segments = 0.0;  ///< [m] the same at ten points of every segment
  BandCosts cost;                   ///< soft costs at the file's weights, no factor 1/2
};

/// `start`: body velocity at the first pose; obstacles are where they are at time 0 of the band.
BandQuality evaluate_band(const std::vector<EvaluatedPose>& band, const Twist2& start, const SceneFile& rules,
                          const std::vector<SceneObstacle>& obstacles);

/// Poses and intervals of a trajectory.
std::vector<EvaluatedPose> to_band(const std::vector<TrajectoryPoint>& trajectory);

/// Velocity of the segment from a to b as the rules define it.
Twist2 segment_twist(const EvaluatedPose& a, const EvaluatedPose& b);

}  // namespace bw
