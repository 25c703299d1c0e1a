#include "components/lab/battery/battery.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace bw {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, '|');) {
    const std::size_t begin = cell.find_first_not_of(' ');
    const std::size_t end = cell.find_last_not_of(' ');
    cells.push_back(begin == std::string::npos ? "" : cell.substr(begin, end - begin + 1));
  }
  return cells;
}

std::vector<std::string> tests_named(const std::string& cell) {
  static const std::regex kTest("`([A-Za-z0-9_]+\\.[A-Za-z0-9_]+)`");
  std::vector<std::string> tests;
  for (std::sregex_iterator it(cell.begin(), cell.end(), kTest), end; it != end; ++it) {
    const std::string name = (*it)[1];
    if (!name.ends_with(".sh") && !name.ends_with(".cpp")) tests.push_back(name);
  }
  return tests;
}

int number_in(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || number < 1)
    throw std::runtime_error(fmt::format("--rows: no row: {}", text));
  return number;
}

/// The last match of the first group that matched.
std::optional<std::string> last_match(const std::string& text, const char* pattern) {
  const std::regex wanted(pattern);
  std::optional<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), wanted), end; it != end; ++it) found = (*it)[1];
  return found;
}

}  // namespace

std::vector<BatteryRow> rows_of(const std::string& readme, int count) {
  std::vector<BatteryRow> rows;
  std::istringstream in(readme);
  bool is_inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("| row | hazard |")) {
      is_inside = true;
      continue;
    }
    if (!is_inside || line.starts_with("|-")) continue;
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() < 6) break;
    const int number = static_cast<int>(rows.size()) + 1;
    if (number > count) break;
    rows.push_back({.number = number, .hazard = cells[2], .tests = tests_named(cells[5])});
  }
  if (rows.empty()) throw std::runtime_error("there is no table of hazards: --table names tests/README.md");
  return rows;
}

std::vector<std::string> tests_listed(const std::string& listing) {
  std::vector<std::string> tests;
  std::istringstream in(listing);
  std::string suite;
  for (std::string line; std::getline(in, line);) {
    line = line.substr(0, line.find("  #"));
    if (line.empty()) continue;
    if (line.front() != ' ') {
      suite = line.ends_with('.') ? line.substr(line.rfind('/') + 1) : "";
      continue;
    }
    const std::string name = line.substr(line.find_first_not_of(' '));
    const std::string whole = suite + name.substr(0, name.find('/'));
    if (!suite.empty() && std::ranges::find(tests, whole) == tests.end()) tests.push_back(whole);
  }
  return tests;
}

std::string filter_of(const std::vector<std::string>& tests) {
  std::vector<std::string> patterns;
  for (const std::string& test : tests) patterns.push_back(test + ":*/" + test + "/*");
  return fmt::format("{}", fmt::join(patterns, ":"));
}

int asked_of(int row) {
  switch (row) {
    case 1:
    case 2:
    case 4:
    case 20:
      return 300;
    case 5:
      return 50;
    case 35:
      return 1000;
    default:
      return 59;
  }
}

std::vector<BatteryCommand> real_time_commands() {
  return {{1, {"lose_commander", "cmd_vel", "{n}"}, true},
          {2, {"lose_commander", "wheel_commands", "{n}"}, true},
          {1, {"bandwagon-lab", "injections", "--injections", "{n}"}, true},
          {4, {"kill_base", "KILL", "{n}"}, true},
          {5, {"bandwagon-lab", "loops", "--kill", "--loops", "{n}"}, true},
          {35, {"bandwagon-lab", "loops", "--loops", "{n}"}, true}};
}

std::vector<BatteryCommand> test_commands(const std::vector<BatteryRow>& rows,
                                          const std::map<std::string, std::vector<std::string>>& programs) {
  std::vector<BatteryCommand> commands;
  for (const BatteryRow& row : rows) {
    for (const auto& [program, its] : programs) {
      std::vector<std::string> mine;
      std::ranges::copy_if(row.tests, std::back_inserter(mine), [&](const std::string& test) {
        return std::ranges::find(its, test) != its.end();
      });
      if (!mine.empty()) commands.push_back({row.number, {program, "--gtest_filter=" + filter_of(mine)}});
    }
  }
  return commands;
}

BatteryFigures figures_of(const std::string& output, int status) {
  BatteryFigures figures;
  int most = 0;
  static const std::regex kTrials("([0-9]+) (?:trials|injections|loops)|[0-9]+ of ([0-9]+) within");
  for (std::sregex_iterator it(output.begin(), output.end(), kTrials), end; it != end; ++it)
    most = std::max(most, std::stoi((*it)[1].matched ? (*it)[1].str() : (*it)[2].str()));
  figures.has_trials = most > 0;
  figures.n = most;
  if (most == 0)
    figures.n = std::stoi(last_match(output, "\\[==========\\] ([0-9]+) tests? from .* ran").value_or("0"));
  const int failed = std::stoi(last_match(output, "([0-9]+) failures").value_or("0"));
  const int red = std::stoi(last_match(output, "\\[  FAILED  \\] ([0-9]+) tests?, listed").value_or("0"));
  figures.failures = std::max({failed, red, status == 0 ? 0 : 1});
  figures.worst = last_match(output, "([0-9.]+ m?s) at the latest").value_or("");
  if (figures.worst.empty()) figures.worst = last_match(output, "worst ([0-9.]+ m?s)").value_or("");
  return figures;
}

std::string battery_table(const std::vector<BatteryResult>& results) {
  constexpr std::size_t kWidth = 44;
  std::string text = fmt::format("{:>3}  {:{}}  {:>12} {:>6} {:>9}  {:>8}  {}\n", "row", "hazard", kWidth,
                                 "n", "asked", "failures", "worst", "command");
  for (const auto& [row, commands] : results) {
    std::string hazard = row.hazard.substr(0, kWidth);
    if (commands.empty()) {
      text += fmt::format("{:3}  {:{}}  {:>12} {:6} {:>9}  {:>8}  {}\n", row.number, hazard, kWidth, "-",
                          asked_of(row.number), "-", "-", "not run");
      continue;
    }
    for (const auto& [typed, figures] : commands) {
      text += fmt::format("{:3}  {:{}}  {:>12} {:6} {:9}  {:>8}  {}\n", row.number, hazard, kWidth,
                          fmt::format("{} {}", figures.n, figures.has_trials ? "trials" : "tests"),
                          asked_of(row.number), figures.failures, figures.worst.empty() ? "-" : figures.worst,
                          typed);
      hazard = "";
    }
  }
  const auto ran = std::ranges::count_if(results, [](const auto& one) { return !one.commands.empty(); });
  return text + fmt::format("{} of {} rows ran, {} with failures; {} not run\n", ran, results.size(),
                            failed_rows(results), static_cast<int>(results.size()) - ran);
}

int failed_rows(const std::vector<BatteryResult>& results) {
  return static_cast<int>(std::ranges::count_if(results, [](const BatteryResult& result) {
    return std::ranges::any_of(result.commands, [](const auto& one) { return one.second.failures > 0; });
  }));
}

std::vector<int> rows_named(std::string_view text) {
  std::set<int> rows;
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const std::string_view part = text.substr(0, comma);
    text.remove_prefix(std::min(comma + 1, text.size()));
    const std::size_t dash = part.find('-');
    const int first = number_in(part.substr(0, dash));
    const int last = dash == std::string_view::npos ? first : number_in(part.substr(dash + 1));
    for (int row = first; row <= std::min(last, 1000); ++row) rows.insert(row);
  }
  return {rows.begin(), rows.end()};
}

}  // namespace bw
