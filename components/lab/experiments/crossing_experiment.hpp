// Experiment E5 (protocols.md 8.5): which planner passes behind people who cross?
#pragma once

#include <string>
#include <vector>

#include "components/lab/bench/crowd_episode.hpp"
#include "components/lab/experiments/crossing_scene.hpp"

namespace bw {

inline constexpr int kCrossingRuns = 40;  ///< with fewer only what must hold of every run is judged

/// One planner as it takes part.
struct CrossingEntry {
  std::string label;
  std::string planner;
  std::vector<std::string> set;  ///< parameters unlike the defaults, as `bandwagon bench crowd --set`
};

struct CrossingRun {
  std::uint64_t seed = 0;
  Passing passing_a = Passing::not_crossed;
  Passing passing_b = Passing::not_crossed;
  CrowdEpisode episode;
  std::vector<TimedPosition> path;
};

struct CrossingResult {
  CrossingEntry entry;
  std::vector<CrossingRun> runs;
};

/// A planner's view at one moment of a run.
struct CrossingSnapshot {
  double time = 0.0;  ///< [s]
  Pose2 robot;
  std::vector<Mover> people;  ///< A, then B
  std::vector<Vector2> path;  ///< driven so far
  PlanningResult plan;
};

/// Means and shares over all runs.
struct CrossingSummary {
  int runs = 0, successes = 0, contacts = 0;
  double share_behind_a = 0.0, share_behind_b = 0.0;
  double mean_max_collision_index = 0.0, max_collision_index = 0.0;
  double mean_time = 0.0;
  double mean_min_clearance = 0.0;  ///< [m] centre of the robot to a person's edge
};

/// Seeds 1 to `runs`. Deterministic but for the cycle times. Throws std::runtime_error on an unknown planner
/// or parameter.
CrossingResult run_crossing(const CrossingEntry& entry, const CrossingGeometry& geometry, int runs);

/// The run of `seed` once more, as it was at the first planner call at or after each of `times` [s], which
/// rise. Those after its end are left out. Throws as run_crossing().
std::vector<CrossingSnapshot> crossing_snapshots(const CrossingEntry& entry, const CrossingGeometry& geometry,
                                                 std::uint64_t seed, const std::vector<double>& times);

CrossingSummary summarize(const CrossingResult& result);

}  // namespace bw
