// The battery: rows of the table of hazards (tests/README.md), each shown by the tests that it names and by programs that repeat
// a fault in real time. Values only; battery_verb.cpp runs them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bw {

struct BatteryRow {
  int number = 0;
  std::string hazard;
  std::vector<std::string> tests;  ///< Suite.Test
};

/// Of the first `rows` of the table in a text as tests/README.md. Throws std::runtime_error where there is none.
std::vector<BatteryRow> rows_of(const std::string& readme, int rows = 36);

/// Of `--gtest_list_tests`: Suite.Test, once each, whatever their parameters are.
std::vector<std::string> tests_listed(const std::string& listing);
/// That selects them in a program, with all of their parameters.
std::string filter_of(const std::vector<std::string>& tests);

/// How often a row is to be repeated without a failure: 300 of rows 1, 2, 4 and 20; 1,000 of row 35; 50 of row 5; else 59.
int asked_of(int row);

/// One program of a row.
struct BatteryCommand {
  int row = 0;
  std::vector<std::string> words;  ///< the program's name first; {n} stands for the repetitions
  bool in_real_time = false;       ///< its figures need a machine that does nothing else
};
/// That repeat faults in real time, beside the tests.
std::vector<BatteryCommand> real_time_commands();
/// One for each program that has tests of the row. `programs`: tests by program.
std::vector<BatteryCommand> test_commands(const std::vector<BatteryRow>& rows,
                                          const std::map<std::string, std::vector<std::string>>& programs);

/// What a command printed, and how it ended.
struct BatteryFigures {
  int n = 0;  ///< repetitions that it tells, or tests
  bool has_trials = false;
  int failures = 0;
  std::string worst;  ///< as it is told, "290 ms"; empty: no figure
};
BatteryFigures figures_of(const std::string& output, int status);

/// Of all commands of a row; nothing for one that was not run. `asked`: by rows.
struct BatteryResult {
  BatteryRow row;
  std::vector<std::pair<std::string, BatteryFigures>> commands;  ///< as they are typed
};
/// One line each: what was not run is said to be so, and never counts as passed.
std::string battery_table(const std::vector<BatteryResult>& results);
/// Rows that ran and had a failure.
int failed_rows(const std::vector<BatteryResult>& results);

/// "1,2,6-8": {1, 2, 6, 7, 8}; empty: none is named. Throws std::runtime_error.
std::vector<int> rows_named(std::string_view text);

}  // namespace bw
