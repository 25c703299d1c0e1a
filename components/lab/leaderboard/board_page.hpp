// A leaderboard as a page.
#pragma once

#include <vector>

#include "components/lab/leaderboard/board.hpp"
#include "components/lab/report/document.hpp"

namespace bw {

/// Who wins where, then a table and the failures of each suite.
report::Document board_page(const std::vector<BoardSuite>& suites);

/// {suites: [{name, whole_graph, made, rows: [{planner, drives, starts, successes, success95, wins, ...}]}]}.
nlohmann::ordered_json to_json(const std::vector<BoardSuite>& suites);

}  // namespace bw
