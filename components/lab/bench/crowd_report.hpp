// The figures of one planner over crowd scenes, as JSON for scripts and as a table for people.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "components/lab/bench/crowd_episode.hpp"
#include "components/lab/bench/drive_rates.hpp"
#include "components/lab/comparison/comparison_report.hpp"

namespace bw {

/// Means are over all episodes.
struct CrowdSummary {
  DriveRates rates;
  int contacts = 0, contacts_at_speed = 0;
  int reached_without_contact_at_speed = 0;
  double mean_time = 0.0;
  double mean_min_clearance = 0.0, min_clearance = 0.0;
  double mean_max_collision_index = 0.0, max_collision_index = 0.0;
};

/// `contacts` are those that were judged.
std::vector<RatedDrive> rated(const std::vector<CrowdEpisode>& episodes);

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

}  // namespace bw
