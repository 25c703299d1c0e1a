// `bandwagon bench crowdnav`: CrowdNav's circle and square (protocols.md 8.11), without DDS.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "components/lab/bench/crowdnav_report.hpp"
#include "components/local_planner/planner_registry.hpp"

namespace bw {

/// Beside the local planners: CrowdNav's own ORCA, which moves any way.
inline constexpr const char* kHolonomicOrca = "orca_holonomic";

struct BenchCrowdNavArguments {
  CrowdNavCrossing crossing = CrowdNavCrossing::circle;
  bool visible = false;  ///< people see the robot
  int first_case = 0;
  int cases = kCrowdNavCases;  ///< from the first on; fewer where the 500 end
  std::vector<std::string> planners = {kHolonomicOrca};
  double safety_space = 0.0;                    ///< [m] by which orca_holonomic widens everybody
  std::function<void(PlannerOptions&)> adjust;  ///< last word on the options; may be empty
  int jobs = 1;               ///< cases at a time; above 1 the times are those of their threads
  bool with_samples = false;  ///< every step goes into the JSON
  std::string json;           ///< output file; empty: none
};

/// One planner after the other. Prints a table, writes JSON {scene, visible, planners: [{planner, episodes,
/// summary, conditions}, ...]}.
/// Returns the exit status (0). Throws std::runtime_error on unusable names.
int bench_crowdnav(const BenchCrowdNavArguments& arguments);

}  // namespace bw
