// The figures of one planner over CrowdNav's cases, as JSON for scripts and as a table for people.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "components/lab/bench/crowdnav_episode.hpp"
#include "components/lab/bench/drive_rates.hpp"

namespace bw {

struct CrowdNavSummary {
  DriveRates rates;
  int collisions = 0;
  double mean_time = 0.0;                    ///< [s] of the successes
  double discomfort = 0.0;                   ///< share of all steps
  double intrusion = 0.0;                    ///< share of the steps of a drive, mean
  double path = 0.0;                         ///< [m] mean
  double mean_min_gap = 0.0, min_gap = 0.0;  ///< [m]
};

std::vector<RatedDrive> rated(const std::vector<CrowdNavEpisode>& episodes);

CrowdNavSummary summarize(const std::string& planner, const std::vector<CrowdNavEpisode>& episodes);

/// {planner, episodes: [...], summary: {...}}.
nlohmann::ordered_json to_json(const CrowdNavSummary& summary, const std::vector<CrowdNavEpisode>& episodes);

/// {t, pose: [x, y, theta], velocity: [vx, vy], people: [[x, y, vx, vy], ...]}.
nlohmann::ordered_json to_json(const CrowdNavSample& sample);

std::string in_a_line(const CrowdNavEpisode& episode);

/// One row per planner below a head, and who hit whom.
std::string table(const std::vector<CrowdNavSummary>& summaries);

}  // namespace bw
