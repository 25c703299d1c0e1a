#include "components/lab/leaderboard/board_page.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace bw {
namespace {

constexpr std::size_t kFailures = 30;  // that are named of each suite

std::string success_of(const BoardFigures& f) {
  return fmt::format("{:.1f} % ({:.1f} to {:.1f})", 100.0 * f.share(), 100.0 * f.success.low,
                     100.0 * f.success.high);
}

using SuiteFigures = std::vector<BoardFigures>;

// Of planners alone, or of whole graphs.
report::Table who_wins(const std::vector<BoardSuite>& suites, const std::vector<SuiteFigures>& figures,
                       bool whole_graph) {
  std::vector<std::string> planners;
  for (std::size_t k = 0; k < suites.size(); ++k)
    for (const BoardRow& row : suites[k].rows)
      if (suites[k].whole_graph == whole_graph && std::ranges::find(planners, row.planner) == planners.end())
        planners.push_back(row.planner);
  std::vector<report::Head> heads{whole_graph ? "whole graphs" : "planners alone"};
  heads.insert(heads.end(), planners.begin(), planners.end());
  report::Table table(heads);
  for (std::size_t k = 0; k < suites.size(); ++k) {
    if (suites[k].whole_graph != whole_graph) continue;
    std::vector<report::Cell> cells{suites[k].name};
    for (const std::string& planner : planners) {
      const auto f = std::ranges::find(figures[k], planner, &BoardFigures::planner);
      if (f == figures[k].end())
        cells.emplace_back("");
      else
        cells.emplace_back(report::Verdict{fmt::format("{:.1f} %", 100.0 * f->share()),
                                           f->wins ? report::Tone::met : report::Tone::plain});
    }
    table.row(cells);
  }
  return table;
}

struct FigureColumn {
  const char* head;
  std::optional<double> BoardFigures::*figure;
};
constexpr FigureColumn kFigures[] = {{"score", &BoardFigures::score},
                                     {"time [s]", &BoardFigures::time},
                                     {"way [m]", &BoardFigures::path},
                                     {"jerk [m/s^3]", &BoardFigures::jerk},
                                     {"largest CI", &BoardFigures::collision_index},
                                     {"cycle [ms]", &BoardFigures::cycle}};

std::string beside_the_best(const Comparison& c) {
  if (c.pairs == 0) return "no drive of both";
  return fmt::format("{:+.1f} ({:+.1f} to {:+.1f}) points in {} pairs, p {:.2g}", 100.0 * c.success.mean,
                     100.0 * c.success.low, 100.0 * c.success.high, c.pairs, c.p);
}

// Columns of which some row has a figure.
report::Table rows_of(const SuiteFigures& figures) {
  std::vector<report::Head> heads{"planner", "drives", "starts", "success (95 % over starts)",
                                  "beside the best"};
  std::vector<FigureColumn> columns;
  for (const FigureColumn& column : kFigures) {
    if (std::ranges::none_of(figures, [&](const BoardFigures& f) { return (f.*column.figure).has_value(); }))
      continue;
    columns.push_back(column);
    heads.emplace_back(column.head);
  }
  heads.emplace_back("contacts by who moved");
  report::Table table(heads);
  for (std::size_t k = 0; k < figures.size(); ++k) {
    const BoardFigures& f = figures[k];
    std::vector<report::Cell> cells{f.planner, f.drives, f.starts, success_of(f),
                                    k == 0 ? "the best" : beside_the_best(f.against_best)};
    for (const FigureColumn& column : columns) cells.emplace_back(f.*column.figure);
    cells.emplace_back(f.contacts.in_words());
    table.row(cells);
  }
  return table;
}

std::vector<std::string> failures_of(const BoardSuite& suite) {
  std::vector<std::string> failures;
  std::size_t more = 0;
  for (const BoardRow& row : suite.rows) {
    for (const BoardDrive& drive : row.drives) {
      if (drive.success) continue;
      if (failures.size() >= kFailures) {
        ++more;
        continue;
      }
      std::string name = report::plain(fmt::format("{}, {}", row.planner, drive.key));
      if (!drive.page.empty()) name = fmt::format("[{}]({})", name, drive.page);
      failures.push_back(fmt::format("{}: contacts {}", name, drive.contacts.in_words()));
    }
  }
  if (more > 0) failures.push_back(fmt::format("and {} more", more));
  return failures;
}

// Once each: a file may hold several rows.
std::vector<std::string> made_of(const BoardSuite& suite) {
  std::vector<std::string> all;
  for (const BoardRow& row : suite.rows)
    if (const std::string made = report::plain(row.made); std::ranges::find(all, made) == all.end())
      all.push_back(made);
  return all;
}

}  // namespace

report::Document board_page(const std::vector<BoardSuite>& suites) {
  std::vector<SuiteFigures> figures;
  for (const BoardSuite& suite : suites) figures.push_back(figures_of(suite));
  report::Document page("Leaderboard");
  page.heading("Leaderboard", 1);
  page.text(
      "Success is one thing in all suites: the goal in time, without any contact, however slow the robot was and whoever "
      "walked into whom. Green: the best of a suite, and who is not shown to be worse (McNemar on the episodes that both "
      "drove, p at least 0.05; few drives show little). Intervals are by bootstrap over starts and worlds.");
  for (const bool whole_graph : {false, true}) page.table(who_wins(suites, figures, whole_graph));
  for (const bool whole_graph : {false, true}) {
    for (std::size_t k = 0; k < suites.size(); ++k) {
      if (suites[k].whole_graph != whole_graph) continue;
      page.heading(suites[k].name);
      page.text(whole_graph ? "Whole graphs." : "Planners alone.");
      page.table(rows_of(figures[k]));
      page.list("Failed:", failures_of(suites[k]));
      page.list("Driven by:", made_of(suites[k]));
    }
  }
  return page;
}

nlohmann::ordered_json to_json(const std::vector<BoardSuite>& suites) {
  using Json = nlohmann::ordered_json;
  const auto value = [](const std::optional<double>& figure) { return figure ? Json(*figure) : Json(); };
  Json all = Json::array();
  for (const BoardSuite& suite : suites) {
    Json rows = Json::array();
    for (const BoardFigures& f : figures_of(suite))
      rows.push_back({{"planner", f.planner},
                      {"made", std::ranges::find(suite.rows, f.planner, &BoardRow::planner)->made},
                      {"drives", f.drives},
                      {"starts", f.starts},
                      {"successes", f.successes},
                      {"success95", {f.success.low, f.success.high}},
                      {"wins", f.wins},
                      {"less_than_best", f.against_best.success.mean},
                      {"mcnemar_p", f.against_best.p},
                      {"pairs", f.against_best.pairs},
                      {"score", value(f.score)},
                      {"time_s", value(f.time)},
                      {"path_m", value(f.path)},
                      {"rms_jerk_mps3", value(f.jerk)},
                      {"max_collision_index", value(f.collision_index)},
                      {"cycle_ms", value(f.cycle)},
                      {"contacts", f.contacts.to_json()}});
    all.push_back({{"name", suite.name}, {"whole_graph", suite.whole_graph}, {"rows", std::move(rows)}});
  }
  return {{"suites", std::move(all)}};
}

}  // namespace bw
