// Is a tree worse than the one before? The same drives by the same planners, against what was written then.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "components/lab/leaderboard/board.hpp"

namespace bw {

/// Success by episode, of each planner of each suite.
using GateRecord = std::map<std::string, std::map<std::string, std::map<std::string, bool>>>;

GateRecord record_of(const std::vector<BoardSuite>& suites);
/// Throws std::runtime_error that names the file.
GateRecord read_gate(const std::filesystem::path& file);
/// The same record, the same bytes.
std::string to_text(const GateRecord& record);

struct GateRow {
  std::string suite, planner;
  int pairs = 0;   ///< episodes that are in both
  int lost = 0;    ///< succeeded then, and do not now
  int won = 0;     ///< the other way round
  double p = 1.0;  ///< McNemar's, two-sided
  bool failed = false;
};

inline constexpr double kGate = 0.01;  ///< p below which more lost than won fails

/// Rows that are in both. Throws std::runtime_error where none is: then nothing was compared.
std::vector<GateRow> compare(const GateRecord& before, const GateRecord& now);

}  // namespace bw
