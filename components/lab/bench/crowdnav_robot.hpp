// The robot in CrowdNav's scenes: one that may move any way, by ORCA or social force as CrowdNav has them, or a
// differential drive with a planner of this project (protocols.md 8.11). Metres, seconds.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "components/evaluation/possible/search_scene.hpp"
#include "components/lab/bench/bench_common.hpp"
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
  /// Who is there at the end of a step, before anybody else comes.
  virtual void see(const std::vector<CrowdNavAgent>&) {}
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

/// The velocity of an agent on the way to its goal among others.
using CrowdNavPolicy =
    std::function<Vector2(const CrowdNavAgent&, const Vector2&, const std::vector<CrowdNavAgent>&)>;

/// Takes any velocity of at most 1 m/s at once, decides every step. Who is beyond its range walks on as it saw them last.
/// Gaps as CrowdNav reckons them: as if everybody kept the velocity they had before the step.
std::unique_ptr<CrowdNavRobot> holonomic_robot(const CrowdNavScene& scene, CrowdNavPolicy policy,
                                               const CpuClock& clock);
/// By ORCA; by default everybody is as wide as for the people.
std::unique_ptr<CrowdNavRobot> holonomic_orca_robot(const CrowdNavScene& scene, double safety_space,
                                                    const CpuClock& clock);

/// CrowdNav++'s ORCA robot as it was published: to the end it takes everybody for whom it saw in their place at the
/// beginning of case 0.
std::unique_ptr<CrowdNavRobot> published_orca_robot(const CrowdNavScene& scene, const CpuClock& clock);

/// Limits of bench crowd; every 0.1 s the planner gets true positions and velocities of those within range. Gaps by what
/// everybody really does. `planner` must outlive the robot, and should be new.
std::unique_ptr<CrowdNavRobot> planner_robot(const CrowdNavScene& scene, LocalPlanner& planner,
                                             const CpuClock& clock);

}  // namespace bw
