// The robot in CrowdNav's scenes: one that may move any way, by ORCA as CrowdNav has it, or a differential
// drive with a planner of this project (protocols.md 8.11). Metres, seconds.
#pragma once

#include <memory>
#include <vector>

#include "components/evaluation/possible/search_scene.hpp"
#include "components/lab/bench/crowd_episode.hpp"
#include "components/lab/bench/crowdnav_people.hpp"
#include "components/model/limits.hpp"
#include "components/model/planning.hpp"

namespace bw {

class CrowdNavRobot {
 public:
  virtual ~CrowdNavRobot() = default;
  virtual Pose2 pose() const = 0;
  /// As the people see it, if they do.
  virtual CrowdNavAgent agent() const = 0;
  /// Moves for kCrowdNavStep among `people`, who walk `velocities` [m/s] from now on. The least gap between
  /// the robot and one of them [m], below 0 when they meet.
  virtual double step(const std::vector<CrowdNavAgent>& people, const std::vector<Vector2>& velocities) = 0;
  /// Of what was driven so far [m/s^3].
  virtual double rms_jerk() const = 0;
  /// How it moved, every 0.01 s since the start; empty for one that no limits bind.
  virtual std::vector<possible::MotionState> motion() const { return {}; }
  /// CPU time of every decision.
  const std::vector<double>& ms() const { return ms_; }

 protected:
  void took(double ms) { ms_.push_back(ms); }

 private:
  std::vector<double> ms_;
};

/// Takes any velocity of at most 1 m/s at once, decides every step. Gaps as CrowdNav reckons them: as if
/// everybody kept the velocity they had before the step.
std::unique_ptr<CrowdNavRobot> holonomic_orca_robot(const CrowdNavScene& scene, double safety_space,
                                                    const CpuClock& clock);

/// Limits of bench crowd; every 0.1 s the planner gets the true positions and velocities. Gaps by what
/// everybody really does. `planner` must outlive the robot, and should be new.
std::unique_ptr<CrowdNavRobot> planner_robot(const CrowdNavScene& scene, LocalPlanner& planner,
                                             const CpuClock& clock);

/// The least distance [m] between two points within `duration` [s], one seen from the other at `offset`,
/// moving at `velocity`.
double closest_approach(const Vector2& offset, const Vector2& velocity, double duration);

}  // namespace bw
