// The score card of a run as the JSON that scripts and benchmarks rely on (fields: README of evaluation).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/score_card.hpp>
#include <nlohmann/json_fwd.hpp>

#include "components/program/run_observer.hpp"
#include "runtime/host/statistics.hpp"

namespace bw {

struct RunFacts {
  std::string graph;
  std::uint64_t seed = 0;
  std::string planner_component;  ///< instance whose control_cycle is the planner's; empty: there is none
  std::string planner_name;
  double realtime_factor = 0.0;
  std::string samples_sha256;
  std::string end_reason;
  bool has_goal = true;  ///< false: the whole run is scored, and nobody drives
  bool stays = false;    ///< the whole run is scored, and the last goal's outcome counts
};

/// The statistics of the planner's cycle, the callback `control_cycle`. Throws std::runtime_error when
/// `component` has none of that name: a time of 0 would pass for a fast planner.
const CallbackStatistics& planner_cycle(const std::vector<CallbackStatistics>& statistics,
                                        const std::string& component);

/// The robot's true path in map as [[t, x, y, theta], ...]: t [s] since the drive began, positions [m],
/// heading [rad].
/// One point every 0.5 s, rounded to 1 ms, 1 mm and 1 mrad; what was before the drive is left out.
nlohmann::json path_json(const std::vector<PathPoint>& path, const bandwagon_msgs::msg::ScoreCard& card);

/// The card alone.
nlohmann::json card_json(const bandwagon_msgs::msg::ScoreCard& card);

/// The card of a run with its facts. Throws std::runtime_error like planner_cycle() unless planner_component
/// is empty.
nlohmann::json to_json(const std::optional<bandwagon_msgs::msg::ScoreCard>& card, const RunFacts& facts,
                       const std::vector<CallbackStatistics>& statistics);

/// One of several robots: its card, its planner and its path.
nlohmann::json robot_json(const RobotObservation& seen, const RunFacts& facts,
                          const std::vector<CallbackStatistics>& statistics);

/// The same for people, a few lines.
std::string in_words(const nlohmann::json& score_card);

}  // namespace bw
