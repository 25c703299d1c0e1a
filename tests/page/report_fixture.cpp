// report_fixture FILE.html: a report with every kind of part that there is, for report_test.mjs.
#include <cmath>

#include "components/lab/report/report_page.hpp"

namespace bw {
namespace {

report::Figure charts() {
  report::Figure figure{
      .title = "Curves and ways", .caption = "With **everything** that a chart holds.", .id = "charts"};
  report::Chart time{.title = "Speed",
                     .x = {"time [s]", 0.0, 20.0},
                     .y = {"v [m/s]", 0.0, 1.2},
                     .spans = {{5.0, 8.0, "roof"}},
                     .limits = {{0.54, "0.54 physical"}}};
  for (std::size_t k = 0; k < 3; ++k) {
    time.series.push_back({"robot " + std::to_string(k), report::look_of(k)});
    for (int i = 0; i <= 200; ++i)
      time.series.back().points.emplace_back(0.1 * i,
                                             0.5 + 0.4 * std::sin(0.05 * i + static_cast<double>(k)));
  }
  figure.add(time);
  figure.add(report::Chart{.title = "Error",
                           .x = {"time [s]"},
                           .y = {"error [m], log scale", 0.01, 100.0, true},
                           .series = {{"robot 0", report::look_of(0), {{0.0, 0.02}, {10.0, 5.0}}}}});
  report::Chart floor = report::floor_plan("Room");
  floor.series = {{"way", {.color = report::Color::blue}, {{0.0, 0.0}, {4.0, 1.0}, {8.0, 0.0}}},
                  {"fixes", {.color = report::Color::grey}, {{0.5, 0.2}, {3.0, 0.9}}, true}};
  floor.bodies = {{{4.0, 2.0}, 0.3, report::Color::purple, "A", {0.5, 0.0}, "people"}};
  floor.marks = {{{2.0, 0.5}, report::Symbol::ring, report::Color::red, "late", "missed"},
                 {{5.0, 0.7}, report::Symbol::triangle, report::Color::red, "", "other identity"},
                 {{6.0, 0.6}, report::Symbol::square, report::Color::red, "", "false"},
                 {{7.0, 0.6}, report::Symbol::cross, report::Color::ink, "", "labelled"}};
  floor.areas = {{.outline = {{1.0, -0.5}, {3.0, -0.5}, {3.0, 1.5}}, .is_shade = true, .name = "roof"},
                 {.outline = {{0.0, 0.0}, {0.5, 0.0}, {0.5, 0.3}}, .color = report::Color::green}};
  floor.walls = {{{0.0, 3.0}, {8.0, 3.0}}};
  floor.blocks = {{Vector2(6.0, 2.0), Vector2(7.0, 2.5)}};
  figure.add(floor);
  return figure;
}

report::Figure columns() {
  report::Figure figure{.title = "Columns", .columns = 2};
  report::Columns columns;
  columns.title = "Mean error";
  columns.y = {"ME [m]", 0.0, 1.0};
  columns.measured = "mean, 5 to 95 %";
  columns.runs = "a run";
  columns.columns = {{.label = "DWA",
                      .runs = {0.2, 0.4, 2.0},
                      .measured = report::Interval{0.3, 0.2, 0.4},
                      .published = 0.35},
                     {.label = "EDWA", .color = report::Color::green, .published = 0.9}};
  figure.add(columns);
  return figure;
}

report::Document fixture() {
  report::Document document("A <fixture> of reports");
  report::Table table({"planner", {"time [s]", 1}, "largest CI", "runs", "verdict"});
  table
      .row({"[teb](#charts)", 12.345, report::Interval{0.4321, 0.4, 0.5}, 40,
            report::Verdict{"met", report::Tone::met}})
      .row({"eteb", std::nan(""), 0.02, 40, report::Verdict{"not met", report::Tone::missed}});
  document.heading("A <fixture> of reports", 1)
      .text("With [a link](failed/index.html), and [none](javascript:alert(1)).")
      .outcome(report::Tone::missed, {"1 of 2 criteria are met."}, {"eteb: 0.02"})
      .table(table)
      .figure(charts())
      .heading("Columns")
      .figure(columns())
      .list("Notes:", {"one", "two " + report::plain("[*]")});
  return document;
}

}  // namespace
}  // namespace bw

int main(int argc, char** argv) {
  if (argc != 2 || !bw::can_draw_reports()) return 2;
  bw::write_report_page(bw::fixture(), argv[1]);
  return 0;
}
