// The figures of one planner over CrowdNav's cases, as JSON for scripts and as a table for people.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "components/tools/bench/bench_common.hpp"
#include "components/tools/bench/crowdnav_episode.hpp"
#include "components/tools/contacts/contact_report.hpp"

namespace bw {

struct CrowdNavSummary {
  std::string planner;
  int episodes = 0, successes = 0, collisions = 0, timeouts = 0;
  int possible = 0;  ///< episodes less those whose contact could not have been avoided (book 8.10)
  Interval wilson, wilson_possible;
  HitCounts hits;
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

/// Every failure with its verdict, a line each.
std::string failures(const std::string& planner, const std::vector<CrowdNavEpisode>& episodes);

/// One row per planner below a head, and who hit whom.
std::string table(const std::vector<CrowdNavSummary>& summaries);

}  // namespace bw
