// The drives of an experiment: whole graphs in lock-step, each kept when it is finished.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "components/evaluation/run_recorder.hpp"
#include "components/lab/experiments/reproduce.hpp"
#include "runtime/graph/graph.hpp"

namespace bw {

struct DriveJob {
  std::string title;  ///< for a person, and as name of its files: unique in the experiment
  std::int64_t seed = 1;
  double time_limit = 120.0;  ///< [s]
  std::function<Graph()> graph;
};

struct DrivenJob {
  nlohmann::json card;               ///< score card, without what belongs to the machine
  std::vector<Vector2> course = {};  ///< collision index over time [s], of index_course()
  std::string page = {};             ///< that plays the drive, beside the results; empty: none
};

/// All jobs in their order: from the folder `kept` what an earlier run has finished, the others driven now. A
/// shard drives its part and returns nothing. Of the drives that failed the first 20 get a page in `failed`.
/// Progress goes to stderr. Throws ConfigError before the first drive where a graph is wrong,
/// std::runtime_error when a person interrupts.
std::vector<DrivenJob> drive_all(const std::vector<DriveJob>& jobs, const ReproduceArguments& arguments);

/// The drive once more, for a figure of it; nothing where it had no goal.
std::optional<RunRecording> course_of(const DriveJob& job);

}  // namespace bw
