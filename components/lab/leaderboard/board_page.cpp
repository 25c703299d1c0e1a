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

report::Table who_wins(const std::vector<BoardSuite>& suites,
                       const std::vector<std::vector<BoardFigures>>& figures) {
  std::vector<report::Head> heads{"planner"};
  std::vector<std::string> planners;
  for (std::size_t k = 0; k < suites.size(); ++k) {
    heads.emplace_back(suites[k].name);
    for (const BoardFigures& f : figures[k])
      if (std::ranges::find(planners, f.planner) == planners.end()) planners.push_back(f.planner);
  }
  report::Table table(heads);
  for (const std::string& planner : planners) {
    std::vector<report::Cell> cells{planner};
    for (const std::vector<BoardFigures>& suite : figures) {
      const auto f = std::ranges::find(suite, planner, &BoardFigures::planner);
      if (f == suite.end())
        cells.emplace_back("");
      else
        cells.emplace_back(report::Verdict{fmt::format("{:.1f} %", 100.0 * f->share()),
                                           f->wins ? report::Tone::met : report::Tone::plain});
    }
    table.row(cells);
  }
  return table;
}

report::Table rows_of(const std::vector<BoardFigures>& figures) {
  report::Table table({"planner", "drives", "starts", "success (95 % over starts)", "less than the best", "p",
                       "score", "time [s]", "way [m]", "jerk [m/s^3]", "largest CI", "cycle [ms]",
                       "contacts by who moved"});
  for (const BoardFigures& f : figures) {
    const MeanInterval& less = f.against_best.success;
    table.row({f.planner, f.drives, f.starts, success_of(f),
               fmt::format("{:+.1f} ({:+.1f} to {:+.1f}) points of {} pairs", 100.0 * less.mean,
                           100.0 * less.low, 100.0 * less.high, f.against_best.pairs),
               f.against_best.p, f.score, f.time, f.path, f.jerk, f.collision_index, f.cycle,
               f.contacts.in_words()});
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
  std::vector<std::vector<BoardFigures>> figures;
  for (const BoardSuite& suite : suites) figures.push_back(figures_of(suite));
  report::Document page("Leaderboard");
  page.text(
      "Success is one thing in all suites: the goal in time, without any contact, however slow the robot was and whoever "
      "walked into whom. Green: the best of a suite, and who is not shown to be worse (McNemar on the same episodes, p at "
      "least 0.05). Intervals are by bootstrap over starts and worlds. Planners alone and whole graphs are not compared "
      "with each other.");
  page.table(who_wins(suites, figures));
  for (std::size_t k = 0; k < suites.size(); ++k) {
    page.heading(suites[k].name);
    page.text(suites[k].whole_graph ? "Whole graphs." : "Planners alone.");
    page.table(rows_of(figures[k]));
    page.list("Failed:", failures_of(suites[k]));
    page.list("Driven by:", made_of(suites[k]));
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
