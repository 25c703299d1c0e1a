// One drive through a graph in this process, from start to score card.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/score_card.hpp>
#include <nlohmann/json.hpp>

#include "components/evaluation/judged_contact.hpp"
#include "components/evaluation/run_recorder.hpp"
#include "runtime/graph/graph.hpp"
#include "runtime/host/host.hpp"
#include "runtime/recording/bag/bag_writer.hpp"

namespace bw {

struct DriveSettings {
  HostOptions host;
  std::optional<Duration> longest;  ///< ends then, on the component clock
  std::filesystem::path svg;        ///< picture of the drive; empty: none
  std::filesystem::path html;       ///< one page of the drive, to be played; empty: none
  std::filesystem::path record;     ///< bag of the drive: a folder, or a file.mcap; empty: none
  bag::BagWriterOptions record_options;
  bool snapshots = false;      ///< as the graph says; else its section `snapshot` is not looked at
  bool show_progress = false;  ///< one refreshing line on stderr
  bool course = false;         ///< keeps what a figure of the drive needs: DriveResult::course
  bool contacts =
      false;           ///< the card tells who hit whom, of each robot, and whether it could have been avoided
  bool stays = false;  ///< the run goes on for further goals when one is decided
};

/// What was heard of one robot, and its contacts judged by that.
struct HeardDrive {
  std::string robot;  ///< empty: the only one
  RunRecording recording;
  std::vector<JudgedContact> contacts = {};
};

struct DriveResult {
  RunEnd end;
  bool judged = false;   ///< the graph has an evaluation in the processes that ran
  bool has_goal = true;  ///< false: it scores the whole run, which no goal ends
  std::optional<bandwagon_msgs::msg::ScoreCard> card;
  std::string page_fault;              ///< why there is no page, or what is not on it; empty: all is
  std::optional<RunRecording> course;  ///< if asked for, and there was a goal: the first robot's
  std::vector<HeardDrive> heard;       ///< with DriveSettings::contacts, of each robot
  nlohmann::json json;                 ///< the score card (score_card_json.hpp)
};

/// A callback of the run threw; everything was brought to rest. `what()` names component, callback and
/// exception.
class RunFailed : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The first component of this type in `process` (empty: in any); nullptr if there is none.
const ComponentNode* find_type(const Graph& graph, const std::string& type, const std::string& process);

/// Runs until the goal is decided (unless it stays), `longest` is over, or a person interrupts. Throws
/// ConfigError or std::runtime_error on a wrong configuration, RunFailed when a callback threw.
DriveResult drive(Graph graph, const DriveSettings& options);

}  // namespace bw
