// `bandwagon bench crowdnav`: CrowdNav's circle and square, CrowdNav++'s crowds (protocols.md 8.11, 8.14), without DDS.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "components/lab/bench/crowdnav_report.hpp"
#include "components/local_planner/planner_registry.hpp"

namespace bw {

/// Beside the local planners: CrowdNav's own robots, which move any way.
inline constexpr const char* kHolonomicOrca = "orca_holonomic";
inline constexpr const char* kPublishedOrca = "orca_published";  ///< of CrowdNav++, in its crowds
inline constexpr const char* kHolonomicSocialForce = "social_force_holonomic";

struct BenchCrowdNavArguments {
  CrowdNavCrossing crossing = CrowdNavCrossing::circle;
  CrowdNavConditions conditions;
  int first_case = 0;
  int cases = kCrowdNavCases;  ///< from the first on; fewer where the 500 end
  std::vector<std::string> planners = {kHolonomicOrca};
  std::optional<double> safety_space;  ///< [m] by which orca_holonomic widens everybody; as people do
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
