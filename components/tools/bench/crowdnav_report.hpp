// The figures of one planner over CrowdNav's cases, as JSON for scripts and as a table for people.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "components/tools/bench/bench_common.hpp"
#include "components/tools/bench/crowdnav_episode.hpp"

namespace bw {

struct CrowdNavSummary {
  std::string planner;
  int episodes = 0, successes = 0, collisions = 0, timeouts = 0;
  Interval wilson;
  double mean_time = 0.0;                    ///< [s] of the successes
  double discomfort = 0.0;                   ///< share of all steps
  double mean_min_gap = 0.0, min_gap = 0.0;  ///< [m]
  double mean_rms_jerk = 0.0;
  double mean_ms = 0.0, p95_ms = 0.0, max_ms = 0.0;

  double share(int count) const { return episodes > 0 ? static_cast<double>(count) / episodes : 0.0; }
};

CrowdNavSummary summarize(const std::string& planner, const std::vector<CrowdNavEpisode>& episodes);

/// {planner, episodes: [...], summary: {...}}.
nlohmann::ordered_json to_json(const CrowdNavSummary& summary, const std::vector<CrowdNavEpisode>& episodes);

/// {t, pose: [x, y, theta], velocity: [vx, vy], people: [[x, y, vx, vy], ...]}.
nlohmann::ordered_json to_json(const CrowdNavSample& sample);

std::string in_a_line(const CrowdNavEpisode& episode);

/// One row per planner below a head.
std::string table(const std::vector<CrowdNavSummary>& summaries);

}  // namespace bw
