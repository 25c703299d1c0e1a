// One test case of CrowdNav, by its rules (protocols.md 8.11). Deterministic but for the times.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "components/evaluation/judged_contact.hpp"
#include "components/lab/bench/crowdnav_robot.hpp"
#include "components/lab/bench/crowdnav_scene.hpp"

namespace bw {

enum class CrowdNavOutcome { reached, collision, timeout };

struct CrowdNavEpisode {
  std::string name;
  CrowdNavOutcome outcome = CrowdNavOutcome::timeout;
  double time = 0.0;         ///< [s] after the last step; of a timeout the limit
  int discomfort_steps = 0;  ///< nearer than 0.2 m, and nothing worse or better happened
  int intrusions = 0;        ///< steps that begin where somebody within range will be in the next five
  int steps = 0;
  double path = 0.0;                                         ///< [m]
  double min_gap = std::numeric_limits<double>::infinity();  ///< [m] to anybody
  double rms_jerk = 0.0;                                     ///< [m/s^3]
  std::vector<double> ms;                                    ///< CPU time of every decision
  std::vector<JudgedContact> judged;  ///< of a base with limits; people who do not see it go on for 6 s

  /// It ended with a contact that could not have been avoided.
  bool is_excused() const { return outcome == CrowdNavOutcome::collision && bw::is_excused(judged, 1); }
};

/// What is at the beginning of a step.
struct CrowdNavSample {
  double time = 0.0;  ///< [s]
  Pose2 pose;
  Vector2 velocity{0.0, 0.0};
  std::vector<CrowdNavAgent> people;
};
using CrowdNavObserver = std::function<void(const CrowdNavSample&)>;

/// How a case is driven.
struct CrowdNavConditions {
  bool visible = false;  ///< people see the robot and take it for one of them
  bool sampled = false;  ///< contacts between steps are none, as CrowdNav++ counts them
};

CrowdNavEpisode run_crowdnav(const CrowdNavScene& scene, CrowdNavRobot& robot,
                             const CrowdNavConditions& conditions, const CrowdNavObserver& observer = {});

}  // namespace bw
