#include "components/lab/leaderboard/gate.hpp"

#include <fstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace bw {

GateRecord record_of(const std::vector<BoardSuite>& suites) {
  GateRecord record;
  for (const BoardSuite& suite : suites)
    for (const BoardRow& row : suite.rows)
      for (const BoardDrive& drive : row.drives) record[suite.name][row.planner][drive.key] = drive.success;
  return record;
}

GateRecord read_gate(const std::filesystem::path& file) {
  try {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot be read");
    GateRecord record;
    const nlohmann::json root = nlohmann::json::parse(in);
    for (const auto& [suite, planners] : root.items())
      for (const auto& [planner, drives] : planners.items())
        for (const char* outcome : {"succeeded", "failed"})
          for (const std::string key : drives.at(outcome))
            record[suite][planner][key] = outcome == std::string("succeeded");
    return record;
  } catch (const std::exception& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

std::string to_text(const GateRecord& record) {
  nlohmann::json all = nlohmann::json::object();
  for (const auto& [suite, planners] : record) {
    for (const auto& [planner, drives] : planners) {
      nlohmann::json& row = all[suite][planner];
      row = {{"succeeded", nlohmann::json::array()}, {"failed", nlohmann::json::array()}};
      for (const auto& [key, success] : drives) row[success ? "succeeded" : "failed"].push_back(key);
    }
  }
  return all.dump() + "\n";
}

std::vector<GateRow> compare(const GateRecord& before, const GateRecord& now) {
  std::vector<GateRow> rows;
  for (const auto& [suite, planners] : now) {
    for (const auto& [planner, drives] : planners) {
      if (!before.contains(suite) || !before.at(suite).contains(planner)) continue;
      GateRow row{.suite = suite, .planner = planner};
      for (const auto& [key, success] : before.at(suite).at(planner)) {
        const auto found = drives.find(key);
        if (found == drives.end()) continue;
        ++row.pairs;
        if (success && !found->second) ++row.lost;
        if (!success && found->second) ++row.won;
      }
      row.p = mcnemar_p(row.lost, row.won);
      row.failed = row.p < kGate && row.lost > row.won;
      if (row.pairs > 0) rows.push_back(row);
    }
  }
  if (rows.empty()) throw std::runtime_error("no suite and planner of these results is in the gate's file");
  return rows;
}

}  // namespace bw
