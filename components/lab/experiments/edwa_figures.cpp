#include "components/lab/experiments/edwa_figures.hpp"

#include <algorithm>
#include <cmath>

#include "components/lab/experiments/column_plot.hpp"
#include "components/lab/experiments/figure.hpp"
#include "components/lab/experiments/path_plot.hpp"

namespace bw {
namespace {

constexpr double kBetweenBodies = 2.0;  // [s]
constexpr int kNumberedBody = 2;        // every second one

std::string scene_name(int scene) {
  return "Scenario " + std::to_string(scene + 1) + ": " + std::string(edwa_scene_name(scene)).substr(3);
}

std::string short_name(const EdwaRow& row) {
  return "Scenario " + std::to_string(row.scene + 1) + ", " + to_string(row.pairing);
}

std::string outcome(const EdwaRow& row) {
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
void add_bodies(PathPlot& plot, const EdwaRow& row, const std::vector<std::string_view>& colors) {
  double next = 0.0;
  int number = 0;
  for (const FloorSample& sample : row.example) {
    if (sample.time + 1e-9 < next) continue;
    const std::string label = number % kNumberedBody == 0 ? fixed(next, 0) : "";
    for (std::size_t i = 0; i < sample.places.size(); ++i)
      plot.discs.push_back({.center = sample.places[i], .color = colors[i % colors.size()], .label = label});
    next += kBetweenBodies;
    ++number;
  }
}

PathPlot ways_plot(const EdwaRow& row) {
  const std::vector<std::string_view> colors = {kBlue, kVermilion, kGreen, kPurple};
  PathPlot plot{.title = short_name(row) + ": " + outcome(row)};
  for (const FloorSample& sample : row.example) {
    plot.ways.resize(sample.places.size());
    for (std::size_t i = 0; i < sample.places.size(); ++i) {
      plot.ways[i].style = {.color = colors[i % colors.size()], .width = i == 0 ? 2.2 : 1.3};
      plot.ways[i].points.push_back(sample.places[i]);
    }
  }
  add_bodies(plot, row, colors);
  const double half = row.scene == 0 ? 2.7 : 8.6;  // [m] across
  plot.view.extend(Vector2(-0.9, -half)).extend(Vector2(16.9, half));
  return plot;
}

const PlotStyle kPairingStyles[] = {
    {.color = kVermilion, .dash = "6 3"}, {.color = kBlue}, {.color = kGreen, .dash = "2 2"}};

LinePlot course_plot(const EdwaTable& table, int scene, bool speed) {
  LinePlot plot{.title = scene_name(scene),
                .x = {"time [s]", 0.0, 18.0},
                .y = {speed ? "v [m/s]" : "δmin", 0.0, speed ? 1.1 : 1.05}};
  for (const EdwaRow& row : table.rows) {
    if (row.scene != scene) continue;
    plot.curves.push_back({kPairingStyles[plot.curves.size() % std::size(kPairingStyles)], {}});
    for (const FloorSample& sample : row.example)
      plot.curves.back().points.emplace_back(sample.time, speed ? sample.v : delta_min(sample.gap));
    if (!row.example.empty()) plot.x.high = std::max(plot.x.high, std::ceil(row.example.back().time));
  }
  return plot;
}

}  // namespace

std::string edwa_ways(const EdwaTable& table) {
  Figure figure{
      .title = "Figure 3.3 again: trajectories of the robot and of the others",
      .caption =
          "One run (the first seed). Bodies every 2 s, numbered [s] every 4 s; the robot under test "
          "starts at (0, 0). The source shows the scenes as pictures: places here are proposals. A "
          "run ends at the goal (16, 0) or on a contact.",
      .legend = {{"robot under test", {.color = kBlue, .width = 2.2}},
                 {"first other", {.color = kVermilion}},
                 {"second", {.color = kGreen}},
                 {"third", {.color = kPurple}}}};
  for (const EdwaRow& row : table.rows) figure.pictures.push_back(to_svg(ways_plot(row)));
  return to_html(figure);
}

std::string edwa_courses(const EdwaTable& table) {
  std::string html;
  for (const bool speed : {false, true}) {
    Figure figure{
        .title = speed ? "Figure 3.4 again, second row: speed of the robot"
                       : "Figure 3.4 again, first row: the minimum passing distance",
        .caption = speed ? "Commanded speed of the same runs."
                         : "δ<sub>min</sub>(t) = exp(-(d/3)<sup>2</sup>) of the gap d [m] between the "
                           "robot and the nearest other: the nearer, the closer to 1. One run (the first "
                           "seed); a curve that ends early ended in a contact.",
        .legend = {},
        .columns = 2};
    for (std::size_t i = 0; i < kEdwaPairings.size(); ++i)
      figure.legend.push_back({to_string(kEdwaPairings[i]), kPairingStyles[i]});
    for (int scene = 0; scene < kEdwaScenes; ++scene)
      figure.pictures.push_back(to_svg(course_plot(table, scene, speed)));
    html += to_html(figure);
  }
  return html;
}

std::string edwa_velocities(const EdwaTable& table) {
  Figure figure{.title = "Table 3.2 as a picture: average passing velocity",
                .caption = "Dots: every run that reached its goal.",
                .legend = {{"published", {}, LegendSymbol::published},
                           {"here: mean and standard deviation", {.color = kInk}, LegendSymbol::measured},
                           {"a run", {.color = kGrey}, LegendSymbol::dots}},
                .columns = 2};
  for (int scene = 0; scene < kEdwaScenes; ++scene) {
    ColumnPlot plot{.title = scene_name(scene), .y = {"velocity [m/s]", 0.7, 1.0}, .columns = {}};
    for (const EdwaRow& row : table.rows) {
      if (row.scene != scene) continue;
      PlotColumn column{.label = to_string(row.pairing),
                        .color = kPairingStyles[plot.columns.size() % std::size(kPairingStyles)].color,
                        .measured = ColumnSpread{row.mean, row.mean - row.sd, row.mean + row.sd},
                        .published = row.published};
      for (const EdwaRun& run : row.runs) {
        if (run.outcome == FloorOutcome::reached) column.runs.push_back(run.mean_speed);
      }
      plot.columns.push_back(std::move(column));
    }
    figure.pictures.push_back(to_svg(plot));
  }
  return to_html(figure);
}

}  // namespace bw
