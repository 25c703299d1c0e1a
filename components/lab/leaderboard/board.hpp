// Planners beside each other in several suites: shares of success whose intervals respect that departures of one start are
// not independent, pairs on the same episodes, and who wins where.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "components/lab/comparison/paired.hpp"
#include "components/lab/comparison/rate_interval.hpp"
#include "components/program/contacts/contact_report.hpp"

namespace bw {

struct BoardDrive {
  std::string key;    ///< the same for the same episode
  std::string start;  ///< the world or start that it shares with others
  bool success = false;
  std::optional<double> time;             ///< [s]
  std::optional<double> path;             ///< [m]
  std::optional<double> jerk;             ///< [m/s^3]
  std::optional<double> collision_index;  ///< the largest
  std::optional<double> cycle;            ///< CPU of one, mean [ms]
  std::optional<double> score;            ///< by the suite's own rule
  HitCounts contacts;                     ///< by who moved into whom
  std::string page;                       ///< that plays the drive; empty: none
};

struct BoardRow {
  std::string planner;
  std::string made;  ///< revision, date and command, for who cites it
  std::vector<BoardDrive> drives;
};

struct BoardSuite {
  std::string name;
  bool whole_graph = false;  ///< else the planner alone: rows of the two are not compared
  std::vector<BoardRow> rows;
};

/// A share and its interval at 95 % by bootstrap over starts (Efron 1979): all drives of a start are drawn together. Where
/// each start has one drive this is close to Wilson's; where none or all succeed Wilson's over starts is taken.
Interval success_over_starts(const std::vector<BoardDrive>& drives);

struct BoardFigures {
  std::string planner;
  int drives = 0, starts = 0, successes = 0;
  Interval success;
  std::optional<double> time, path;  ///< of the drives that succeeded, mean
  std::optional<double> jerk, collision_index, cycle;
  std::optional<double> score;  ///< of all drives, mean
  HitCounts contacts;
  Comparison against_best;  ///< this one less the best of the suite, on the episodes that both drove
  bool wins = false;        ///< the best, or not shown to be worse: McNemar's p at least 0.05

  double share() const { return drives > 0 ? static_cast<double>(successes) / drives : 0.0; }
};

/// Best first: by share of success, then by time.
std::vector<BoardFigures> figures_of(const BoardSuite& suite);

}  // namespace bw
