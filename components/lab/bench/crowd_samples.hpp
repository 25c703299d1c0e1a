// What happened in a drive among walkers, period by period, so that anyone can judge it again.
#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "components/lab/bench/crowd_episode.hpp"

namespace bw {

/// One control period from `time` [s] on.
struct CrowdSample {
  double time = 0.0;
  Pose2 pose;      ///< at its beginning
  Twist2 twist;    ///< at its beginning: applied in the period before
  Twist2 command;  ///< of the planner
  Twist2 applied;  ///< all through it: the command within the limits
  struct Walker {
    Vector2 position{0.0, 0.0};
    Vector2 velocity{0.0, 0.0};
    double radius = 0.0;
  };
  std::vector<Walker> walkers;  ///< at its beginning, in the order of the scene
};

/// drive_crowd, and what happened.
CrowdEpisode drive_crowd_sampled(const Scene& scene, const SceneFile& file, LocalPlanner& planner,
                                 const CpuClock& clock, std::vector<CrowdSample>& samples);

/// A list of {t, pose: [x, y, theta], twist: [v, omega], command: [...], applied: [...], walkers: [[x, y, vx,
/// vy, r], ...]}.
nlohmann::ordered_json to_json(const std::vector<CrowdSample>& samples);

}  // namespace bw
