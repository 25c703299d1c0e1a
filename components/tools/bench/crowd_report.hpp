// The figures of one planner over crowd scenes, as JSON for scripts and as a table for people.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "components/tools/bench/bench_common.hpp"
#include "components/tools/bench/crowd_episode.hpp"
#include "components/tools/comparison/comparison_report.hpp"
#include "components/tools/contacts/contact_report.hpp"

namespace bw {

/// Means are over all episodes, those of cycle times over all cycles.
struct CrowdSummary {
  std::string planner;
  int episodes = 0, successes = 0, contacts = 0, contacts_at_speed = 0, timeouts = 0;
  Interval wilson;
  int possible = 0;          ///< episodes in which success was possible (book 8.10)
  Interval wilson_possible;  ///< of the successes among them
  HitCounts hits;
  double mean_time = 0.0;
  double mean_min_clearance = 0.0, min_clearance = 0.0;
  double mean_max_collision_index = 0.0, max_collision_index = 0.0;
  double mean_rms_jerk = 0.0;
  double mean_ms = 0.0, p95_ms = 0.0, max_ms = 0.0;
};

CrowdSummary summarize(const std::string& planner, const std::vector<CrowdEpisode>& episodes);

/// {planner, episodes: [...], summary: {...}}, fields as in the README of the planner.
nlohmann::ordered_json to_json(const CrowdSummary& summary, const std::vector<CrowdEpisode>& episodes);

/// One episode on one line.
std::string in_a_line(const CrowdEpisode& episode);

/// One row per planner below a head, then the contacts of each by who hit whom.
std::string table(const std::vector<CrowdSummary>& summaries);

/// How it ended: "contact at 12.30 s, goal reached in 15.0 s".
std::string outcome_in_words(const CrowdEpisode& episode);

/// For a comparison with another planner in the same scenes.
std::vector<PairedEpisode> paired(const std::vector<CrowdEpisode>& episodes);

/// The episodes that failed, each with its contacts and their verdicts; empty when none did.
std::string failures(const std::string& planner, const std::vector<CrowdEpisode>& episodes);

}  // namespace bw
