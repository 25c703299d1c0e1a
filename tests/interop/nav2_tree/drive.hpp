// A drive through the hallway: our robot in real time, our servers under the names of Nav2's, a manager and a
// tree that are not ours. Every process is ended by its own id.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/interop/process.hpp"

namespace bw::test {

/// The folder of this test's files.
std::string own_folder();

/// `bandwagon run`, until it is interrupted.
class GraphRun {
 public:
  GraphRun(const std::string& graph, const std::vector<std::string>& options = {});
  Process& process() { return process_; }
  /// Ctrl-C; the exit status.
  int stop();

 private:
  Process process_;
};

/// A program of nav2_tree/, until it is interrupted.
class Player {
 public:
  explicit Player(const std::vector<std::string>& command) : process_(command) {}
  Process& process() { return process_; }
  /// Waits for a line of its output.
  bool says(const std::string& line);
  int stop();

 private:
  Process process_;
};

/// world, base, localization, map and collision monitor, with a score card at the end.
class Body {
 public:
  Body(int seed, const std::vector<std::string>& options = {});
  /// Ends the run; what evaluation says of it.
  nlohmann::json stop();

 private:
  std::string card_;
  GraphRun run_;
};

/// Our stand-ins, a process each, and their nodes in the manager's order.
struct StandIns {
  std::vector<std::string> graphs;  ///< in config/graphs/nav2, without .yaml
  std::vector<std::string> nodes;
};

/// Each of them, unconfigured.
std::vector<std::unique_ptr<GraphRun>> start(const StandIns& servers);
/// nav2_manager of these nodes.
Player manage(const std::vector<std::string>& nodes);

/// What nav2_tree tells of a goal in map, when it has ended.
nlohmann::json play_tree(double x, double y);

struct DriveReport {
  nlohmann::json tree;  ///< of nav2_tree
  nlohmann::json card;  ///< of evaluation
  std::string trouble;  ///< of the processes; empty: all came up and went down as they should
  double left = 0.0;    ///< [m] from where the robot truly stands to the goal
};

/// From (1, 0) to (19, 0) with the walkers of `seed`.
DriveReport drive_hallway(int seed, const StandIns& servers);

}  // namespace bw::test
