// The report of ekf_report.hpp: the source's Figures 2.2 to 2.4, and paths on recorded logs.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "components/lab/experiments/caveats.hpp"
#include "components/lab/experiments/ekf_report.hpp"
#include "components/lab/experiments/first_screen.hpp"
#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

using report::Color;
using report::Dash;
using report::Interval;
using report::Look;
using report::plain;

constexpr double kDetail = 3.0;  // [m] about the end of the path
const std::array<Look, kEkfSensorSets.size()> kLooks{{{.color = Color::grey, .dash = Dash::dashes},
                                                      {.color = Color::blue},
                                                      {.color = Color::vermilion, .dash = Dash::dashes},
                                                      {.color = Color::green, .width = 2.2}}};
constexpr std::array<const char*, kEkfSensorSets.size()> kColumns{"encoder", "+ GPS", "+ compass", "all"};

report::Document top(const EkfReport& report) {
  FirstScreen screen{
      .title = "The EKF: Figures 2.2 to 2.4, and real robots",
      .about = fmt::format(
          "What the dissertation publishes of its extended Kalman filter (section 2.2), beside what "
          "is measured here over {} seeds.",
          report.seeds),
      .judged =
          report.real_data ? "the filter in simulation and on recorded logs" : "the filter in simulation",
      .criteria = all_criteria(report),
      .not_judged =
          {"The published variance of the encoders alone (6.12 and 5.93 m²): no drift that starts at zero "
           "has it.",
           "The ways themselves: the source shows their shape, and gives no lengths, rates, noises or "
           "number of runs."},
      .tuned = tuned_to_published("ekf")};
  if (!report.real_data)
    screen.not_judged.push_back("Logs of real robots: " + plain(report.real_data_missing) + ".");
  return begin_report(screen);
}

std::string name_of(EkfPath path) { return path == EkfPath::sinus ? "Sinusoidal" : "Circular"; }

/// The placed rows of one way, in the order of kEkfSensorSets.
std::vector<const EkfRow*> placed_rows(const EkfReport& report, EkfPath path) {
  std::vector<const EkfRow*> rows;
  for (const EkfRow& row : report.rows)
    if (row.path == path && row.noise == EkfWheelNoise::placed) rows.push_back(&row);
  return rows;
}

report::Chart paths_chart(const std::vector<const EkfRow*>& rows, EkfPath path, bool detail) {
  report::Chart plan = report::floor_plan(name_of(path) + (detail ? " trajectory, its end" : " trajectory"));
  std::vector<Vector2> truth;
  for (const EkfSample& sample : rows.front()->example) truth.push_back(sample.truth);
  if (detail && !truth.empty())
    plan.show(
        {truth.back() - Vector2(kDetail, 0.75 * kDetail), truth.back() + Vector2(kDetail, 0.75 * kDetail)});
  plan.series.push_back({"true way", {.width = 1.2}, std::move(truth)});
  for (std::size_t i = detail ? 1 : 0; i < rows.size(); ++i) {
    plan.series.push_back({std::string(kEkfSensorSets[i].name), kLooks[i]});
    for (const EkfSample& sample : rows[i]->example) plan.series.back().points.push_back(sample.estimate);
  }
  return plan;
}

report::Chart error_chart(const std::vector<const EkfRow*>& rows, EkfPath path) {
  report::Chart chart{.title = name_of(path) + ": error of the position",
                      .x = {"time [s]"},
                      .y = {"NE [m], log scale", 0.01, 100.0, true}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    chart.series.push_back({std::string(kEkfSensorSets[i].name), kLooks[i]});
    for (const EkfSample& sample : rows[i]->example)
      chart.series.back().points.emplace_back(sample.time, (sample.estimate - sample.truth).norm());
  }
  return chart;
}

report::Columns statistics_of(const std::vector<const EkfRow*>& rows, EkfPath path, bool variance) {
  report::Columns all{.title = name_of(path) + (variance ? ": variance" : ": mean error"),
                      .y = {variance ? "variance [m²], log scale" : "ME [m], log scale",
                            variance ? 0.001 : 0.05, variance ? 10000.0 : 100.0, true},
                      .measured = "here: mean, 1 to 99 % of the seeds"};
  const auto w = static_cast<std::size_t>(path);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const EkfRow& row = *rows[i];
    std::vector<double> figures;
    for (const EkfErrors& errors : row.runs) figures.push_back(variance ? errors.variance : errors.mean);
    report::Column column{.label = kColumns[i], .color = kLooks[i].color};
    if (!figures.empty())
      column.measured = Interval{variance ? row.mean.variance : row.mean.mean, quantile(figures, 0.01),
                                 quantile(figures, 0.99)};
    column.published = variance ? row.sensors.published_variance[w] : row.sensors.published_mean[w];
    all.columns.push_back(std::move(column));
  }
  return all;
}

report::Figure trajectories(const EkfReport& report) {
  report::Figure figure{
      .title = "Figure 2.2 again: trajectories of the three approaches",
      .caption =
          "One run (seed 1). The fused ways lie within decimetres of the true one, so the end of each way is "
          "shown enlarged, and the error over time on a logarithmic scale. The source gives no lengths, "
          "rates or noises: shapes can be compared, places cannot."};
  for (const EkfPath path : {EkfPath::sinus, EkfPath::circle}) {
    const std::vector<const EkfRow*> rows = placed_rows(report, path);
    if (rows.empty()) continue;
    figure.add(paths_chart(rows, path, false));
    figure.add(paths_chart(rows, path, true));
    figure.add(error_chart(rows, path));
  }
  return figure;
}

report::Figure statistics(const EkfReport& report) {
  report::Figure figure{
      .title = "Figures 2.3 and 2.4 again: ME and MSE of the approaches",
      .caption =
          "Mean error, and its variance about the mean, which the source calls MSE. The bars hold 98 % "
          "of the seeds. The published variance of the encoders alone fits no drift that starts at "
          "zero and is not judged.",
      .columns = 2};
  for (const bool variance : {false, true})
    for (const EkfPath path : {EkfPath::sinus, EkfPath::circle})
      figure.add(statistics_of(placed_rows(report, path), path, variance));
  return figure;
}

report::Table figure_table(const EkfReport& report) {
  report::Table table({"sensors",
                       "way",
                       "filter",
                       {"ME published [m]", 4},
                       "ME [m], 1 to 99 %",
                       {"variance published [m²]", 4},
                       "variance [m²]",
                       "rms [m]"});
  for (const EkfRow& row : report.rows) {
    const auto w = static_cast<std::size_t>(row.path);
    table.row({row.sensors.name, to_string(row.path), to_string(row.noise), row.sensors.published_mean[w],
               Interval{row.mean.mean, quantile_of_means(row, 0.01), quantile_of_means(row, 0.99)},
               row.sensors.published_variance[w], row.mean.variance, row.mean.rms});
  }
  return table;
}

report::Figure recorded_paths(const RealDataResults& results) {
  const report::Series kinds[] = {
      {.name = "reference: fixes, motion capture, or survey", .look = {.color = Color::grey}, .dots = true},
      {.name = "filter with its sensors", .look = {.color = Color::blue}},
      {.name = "without a receiver, or wheels alone",
       .look = {.color = Color::vermilion, .dash = Dash::dashes}}};
  report::Figure figure{.title = "Ways on the recorded logs",
                        .caption = "Not of the source. East or along the reference's x is to the right."};
  for (const RealDataPicture& picture : results.pictures) {
    report::Chart plan = report::floor_plan(picture.title.substr(0, picture.title.find(':')));
    for (const RealDataPicture::Path& path : picture.paths) {
      plan.series.push_back(kinds[plan.series.size() % std::size(kinds)]);
      plan.series.back().points = path.points;
    }
    figure.add(plan);
  }
  return figure;
}

std::string parameters(const RealDataResults& results) {
  const RealDataParameters& p = results.parameters;
  return fmt::format(
      "All that the filter is given, the same for every log: wheels k = {:.4f} m (the Labyrinth declares its own), "
      "gyro {:.2f} rad/s, compass {:.2f} rad (MRCLAM's is made and declared), a compass whose zero is unknown with an "
      "offset of {:.2f} rad; the wheel separations of the bases; variances of fixes and ranges as the logs declare "
      "them. One figure is declared by nobody: position_walk = {:.2f} m per root metre, how far positions and wheels "
      "drift apart by what neither declares. It was chosen with the Husky's outage in view{}.",
      p.sensors.wheel_noise, p.sensors.gyro_noise, p.sensors.compass_noise, p.heading_offset_sigma,
      p.position_walk, results.walks.empty() ? "" : "; the second table shows what it does");
}

void add_real_data(report::Document& document, const RealDataResults& results) {
  report::Table rows({"log",
                      "task",
                      "sensors",
                      "reference [m]",
                      "mean [m]",
                      "rms [m]",
                      "largest [m]",
                      "places",
                      {"from [s]", 1}});
  for (const RealDataRow& row : results.rows)
    rows.row({plain(row.log), plain(row.task), plain(row.sensors), plain(row.reference), row.mean, row.rms,
              row.largest, row.count, row.first_pose});
  report::Table walks({{"position_walk [m/√m]", 2},
                       "Husky, every second fix [m]",
                       "Husky, outage [m]",
                       "MRCLAM, receiver [m]",
                       "MRCLAM, all [m]",
                       "Labyrinth, ranges [m]"});
  for (const WalkRow& row : results.walks)
    walks.row(
        {row.position_walk, row.husky_half, row.husky_outage, row.mrclam_gps, row.mrclam_all, row.labyrinth});
  report::Table logs({"log", "source", "licence"});
  for (const NamedLog& log : results.logs) logs.row({plain(log.name), plain(log.source), plain(log.licence)});
  document.figure(recorded_paths(results))
      .table(rows)
      .text(fmt::format("MRCLAM: means over seeds 1 to {}.", results.seeds))
      .text(parameters(results))
      .table(walks)
      .heading("Logs", 3)
      .table(logs);
}

}  // namespace

report::Document ekf_page(const EkfReport& report) {
  report::Document document = top(report);
  document.heading("E1: the simulated robot (Figures 2.2 to 2.4)")
      .text(
          "A robot at 1 m/s with wheels of unequal size (0.85 %), a receiver (1 Hz, 0.18 m) and a compass (1 Hz, "
          "1 degree): a sine-like way of 120 s and one lap of a circle of 33 m.")
      .figure(trajectories(report))
      .figure(statistics(report))
      .text(
          "**placed**: the filter takes its wheels for far worse than they are (k = 0.03 m), which is what "
          "puts the fused errors where they were published; no evidence of its quality. **matched**: the filter "
          "knows its wheels. With a compass and no receiver the error has no bound: its value depends on the length "
          "of the way.")
      .table(figure_table(report))
      .heading("E7: real robots")
      .text(
          "Error of the position [m] at places that the filter did not know. Husky: outdoors, skid-steered, "
          "against the fixes held out, which err by metres themselves and wander together with those given. "
          "MRCLAM: an iRobot Create, its velocity commands as odometry, against motion capture, from the pose "
          "known at the start. Labyrinth: radio ranges, long by 0.1 m at the median, against its reference. "
          "Reference: an earlier study on the same data, with its own filter and parameters; where none was made "
          "the cell is empty.");
  if (report.real_data) {
    add_real_data(document, *report.real_data);
  } else {
    document.text("Not run: " + plain(report.real_data_missing) + ".");
  }
  return document;
}

}  // namespace bw
