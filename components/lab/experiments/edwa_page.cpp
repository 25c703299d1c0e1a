// The report of edwa_report.hpp: the source's Figures 3.3 and 3.4, and its Table 3.2.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "components/lab/experiments/caveats.hpp"
#include "components/lab/experiments/edwa_report.hpp"
#include "components/lab/experiments/first_screen.hpp"

namespace bw {
namespace {

using report::Color;
using report::Dash;
using report::Look;
using report::plain;

constexpr double kBetweenBodies = 2.0;  // [s]
constexpr int kNumberedBody = 2;        // every second one
constexpr Color kRobots[] = {Color::blue, Color::vermilion, Color::green, Color::purple};
constexpr const char* kRobotNames[] = {"robot under test", "first other", "second", "third"};
const Look kPairingLooks[] = {{.color = Color::vermilion, .dash = Dash::dashes},
                              {.color = Color::blue},
                              {.color = Color::green, .dash = Dash::dots}};

report::Document top(const EdwaTable& table, std::size_t seeds) {
  return begin_report(
      {.title = "EDWA: Figures 3.3 and 3.4, Table 3.2",
       .about = fmt::format(
           "What the dissertation publishes of its enhanced dynamic window approach in simulation "
           "(section 3.1), beside what is measured here over {} seeds.",
           seeds),
       .judged = "EDWA by the published setting",
       .criteria = table.criteria,
       .not_judged = {"Contacts of DWA: plain DWA takes moving robots as standing; counted, not judged.",
                      "Other readings of the source, and EDWA as it drives here: at the end of the page.",
                      "Figure 3.5, the drives of a real robot: pictures without figures."},
       .tuned = tuned_to_published("edwa")});
}

std::string scene_name(int scene) {
  return fmt::format("Scenario {}: {}", scene + 1, edwa_scene_name(scene).substr(3));
}

const char* outcome(const EdwaRow& row) {
  if (row.runs.empty()) return "";
  switch (row.runs.front().outcome) {
    case FloorOutcome::reached:
      return "reached";
    case FloorOutcome::contact:
      return "contact";
    case FloorOutcome::timeout:
      break;
  }
  return "timeout";
}

/// Everybody's body at round times, the time in it at every second one.
void add_bodies(report::Chart& plan, const EdwaRow& row) {
  double next = 0.0;
  int number = 0;
  for (const FloorSample& sample : row.example) {
    if (sample.time + 1e-9 < next) continue;
    const std::string label = number % kNumberedBody == 0 ? fmt::format("{:.0f}", next) : "";
    for (std::size_t i = 0; i < sample.positions.size(); ++i)
      plan.bodies.push_back({.center = sample.positions[i], .color = kRobots[i % 4], .label = label});
    next += kBetweenBodies;
    ++number;
  }
}

report::Chart paths_chart(const EdwaRow& row) {
  report::Chart plan = report::floor_plan(
      fmt::format("Scenario {}, {}: {}", row.scene + 1, to_string(row.pairing), outcome(row)));
  for (const FloorSample& sample : row.example) {
    plan.series.resize(sample.positions.size());
    for (std::size_t i = 0; i < sample.positions.size(); ++i) {
      plan.series[i].name = kRobotNames[i % 4];
      plan.series[i].look = {.color = kRobots[i % 4], .width = i == 0 ? 2.2 : 1.3};
      plan.series[i].points.push_back(sample.positions[i]);
    }
  }
  add_bodies(plan, row);
  const double half = row.scene == 0 ? 2.7 : 8.6;  // [m] across
  plan.show({Vector2(-0.9, -half), Vector2(16.9, half)});
  return plan;
}

report::Figure paths(const EdwaTable& table) {
  report::Figure figure{
      .title = "Figure 3.3 again: trajectories of the robot and of the others",
      .caption =
          "One run (the first seed). Bodies every 2 s, numbered [s] every 4 s; the robot "
          "under test starts at (0, 0). The source shows the scenes as pictures: places here "
          "are proposals. A run ends at the goal (16, 0) or on a contact."};
  for (const EdwaRow& row : table.rows) figure.add(paths_chart(row));
  return figure;
}

report::Chart course_chart(const EdwaTable& table, int scene, bool speed) {
  report::Chart chart{.title = scene_name(scene),
                      .x = {"time [s]", 0.0, 18.0},
                      .y = {speed ? "v [m/s]" : "δmin", 0.0, speed ? 1.1 : 1.05}};
  for (const EdwaRow& row : table.rows) {
    if (row.scene != scene) continue;
    chart.series.push_back(
        {to_string(row.pairing), kPairingLooks[chart.series.size() % std::size(kPairingLooks)]});
    for (const FloorSample& sample : row.example)
      chart.series.back().points.emplace_back(sample.time, speed ? sample.v : delta_min(sample.gap));
    if (!row.example.empty()) chart.x.high = std::max(chart.x.high, std::ceil(row.example.back().time));
  }
  return chart;
}

report::Figure courses(const EdwaTable& table, bool speed) {
  report::Figure figure{
      .title = speed ? "Figure 3.4 again, second row: speed of the robot"
                     : "Figure 3.4 again, first row: the minimum passing distance",
      .caption = speed ? "Commanded speed of the same runs."
                       : "δmin(t) = exp(-(d/3)²) of the gap d [m] between the "
                         "robot and the nearest other: the nearer, the closer to 1. One run (the "
                         "first seed); a curve that ends early ended in a contact.",
      .columns = 2};
  for (int scene = 0; scene < kEdwaScenes; ++scene) figure.add(course_chart(table, scene, speed));
  return figure;
}

report::Figure velocities(const EdwaTable& table) {
  report::Figure figure{.title = "Table 3.2 as a picture: average passing velocity",
                        .caption = "Dots: every run that reached its goal.",
                        .columns = 2};
  for (int scene = 0; scene < kEdwaScenes; ++scene) {
    report::Columns all;
    all.title = scene_name(scene);
    all.y = {"velocity [m/s]", 0.7, 1.0};
    all.measured = "here: mean and standard deviation";
    all.runs = "a run";
    for (const EdwaRow& row : table.rows) {
      if (row.scene != scene) continue;
      report::Column column{.label = to_string(row.pairing),
                            .color = kPairingLooks[all.columns.size() % std::size(kPairingLooks)].color,
                            .measured = report::Interval{row.mean, row.mean - row.sd, row.mean + row.sd},
                            .published = row.published};
      for (const EdwaRun& run : row.runs)
        if (run.outcome == FloorOutcome::reached) column.runs.push_back(run.mean_speed);
      all.columns.push_back(std::move(column));
    }
    figure.add(all);
  }
  return figure;
}

report::Table rows_table(const EdwaTable& table) {
  report::Table rows({"scene",
                      "pairing",
                      {"published [m/s]", 4},
                      {"mean [m/s]", 3},
                      {"sd [m/s]", 3},
                      "runs",
                      "reached",
                      "contacts",
                      "timeouts",
                      {"gain [m/s]", 3},
                      {"mean largest δmin", 3},
                      {"lowest v [m/s]", 2}});
  for (const EdwaRow& row : table.rows)
    rows.row({edwa_scene_name(row.scene), to_string(row.pairing), row.published, row.mean, row.sd,
              row.runs.size(), row.success, row.contacts, row.timeouts, row.gain_on_same_seeds,
              row.mean_max_delta, row.lowest_v});
  return rows;
}

void add_other_readings(report::Document& document, const std::vector<EdwaResult>& results) {
  if (results.size() < 2) return;
  std::vector<report::Head> heads = {"scene", "pairing", {"published", 3}};
  std::vector<std::string> meanings;
  for (const EdwaResult& result : results) {
    heads.emplace_back(result.variant.name);
    meanings.push_back("**" + plain(result.variant.name) + "**: " + plain(result.variant.meaning));
  }
  report::Table table(std::move(heads));
  for (std::size_t i = 0; i < results[0].table.rows.size(); ++i) {
    const EdwaRow& row = results[0].table.rows[i];
    std::vector<report::Cell> cells = {edwa_scene_name(row.scene), to_string(row.pairing), row.published};
    for (const EdwaResult& result : results) {
      const EdwaRow& other = result.table.rows.at(i);
      const std::string mean = std::isfinite(other.mean) ? fmt::format("{:.3f}", other.mean) : "–";
      cells.emplace_back(fmt::format("{} ({}, {})", mean, other.success, other.contacts));
    }
    table.row(cells);
  }
  document.heading("Other readings")
      .list("Mean [m/s] (runs that reached the goal, contacts).", meanings)
      .table(table);
}

}  // namespace

report::Document edwa_page(const std::vector<EdwaResult>& results) {
  const EdwaTable& table = results.at(0).table;
  report::Document document = top(table, table.rows.at(0).runs.size());
  document.heading("E3 and E4: robots among robots")
      .text(
          "A robot over 16 m from rest among robots that plan for themselves; radius 0.3 m, 1 m/s, 0.35 rad/s, "
          "1 m/s², one command every 0.25 s.")
      .figure(paths(table))
      .figure(courses(table, false))
      .figure(courses(table, true))
      .heading("Table 3.2")
      .text(
          "Average passing velocity [m/s]. Means are over the runs that reached the goal: where most DWA runs end in "
          "contact, the mean is that of the easy ones. Gain: over DWA-DWA, on the seeds that both reached.")
      .figure(velocities(table))
      .table(rows_table(table));
  add_other_readings(document, results);
  return document;
}

}  // namespace bw
