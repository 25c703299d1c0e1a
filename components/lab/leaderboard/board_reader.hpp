// What benches and evaluations wrote, as suites of a leaderboard.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "components/lab/leaderboard/board.hpp"

namespace bw {

/// Adds the drives of a file of `evaluate --json`, or of `bench crowd`, `crowdnav`, `corridor`, `dynabarn`, `flows` or `course`. Rows of a
/// suite that is there already stand beside its others; the same planner twice is refused. `label` is put after the planners' names. Throws std::runtime_error that
/// names the file.
void read_board(const std::filesystem::path& file, std::vector<BoardSuite>& suites,
                const std::string& label = "");

}  // namespace bw
