#include "components/lab/experiments/ekf_figures.hpp"

#include <algorithm>

#include "components/lab/experiments/column_plot.hpp"
#include "components/lab/experiments/figure.hpp"
#include "components/lab/experiments/path_plot.hpp"
#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

constexpr double kDetail = 3.0;  // [m] about the end of the way
const PlotStyle kTruth{.color = kInk, .width = 1.2};

struct SensorLook {
  const char* column;
  PlotStyle style;
};
const std::array<SensorLook, kEkfSensorSets.size()> kLooks{
    {{"encoder", {.color = kGrey, .dash = "7 3"}},
     {"+ GPS", {.color = kBlue}},
     {"+ compass", {.color = kVermilion, .dash = "5 2"}},
     {"all", {.color = kGreen, .width = 2.2}}}};

std::string name_of(EkfWay way) { return way == EkfWay::sinus ? "Sinusoidal" : "Circular"; }

/// The placed rows of one way, in the order of kEkfSensorSets.
std::vector<const EkfRow*> placed_rows(const EkfReport& report, EkfWay way) {
  std::vector<const EkfRow*> rows;
  for (const EkfRow& row : report.rows) {
    if (row.way == way && row.noise == EkfWheelNoise::placed) rows.push_back(&row);
  }
  return rows;
}

PathPlot ways_plot(const std::vector<const EkfRow*>& rows, EkfWay way, bool detail) {
  PathPlot plot{.title = name_of(way) + (detail ? " trajectory, its end" : " trajectory")};
  std::vector<Vector2> truth;
  for (const EkfSample& sample : rows.front()->example) truth.push_back(sample.truth);
  for (std::size_t i = detail ? 1 : 0; i < rows.size(); ++i) {
    plot.ways.push_back({kLooks[i].style, {}});
    for (const EkfSample& sample : rows[i]->example) plot.ways.back().points.push_back(sample.estimate);
  }
  plot.ways.push_back({kTruth, truth});
  if (detail && !truth.empty()) {
    plot.view.extend(truth.back() - Vector2(kDetail, 0.75 * kDetail));
    plot.view.extend(truth.back() + Vector2(kDetail, 0.75 * kDetail));
  }
  return plot;
}

LinePlot error_plot(const std::vector<const EkfRow*>& rows, EkfWay way) {
  LinePlot plot{.title = name_of(way) + ": error of the position",
                .x = {"time [s]", 0.0, 1.0},
                .y = {"NE [m], log scale", 0.01, 100.0, true}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    plot.curves.push_back({kLooks[i].style, {}});
    for (const EkfSample& sample : rows[i]->example) {
      plot.curves.back().points.emplace_back(sample.time, (sample.estimate - sample.truth).norm());
      plot.x.high = std::max(plot.x.high, sample.time);
    }
  }
  return plot;
}

ColumnPlot statistics_plot(const std::vector<const EkfRow*>& rows, EkfWay way, bool variance) {
  ColumnPlot plot{.title = name_of(way) + (variance ? ": variance" : ": mean error"),
                  .y = {variance ? "variance [m²], log scale" : "ME [m], log scale", variance ? 0.001 : 0.05,
                        variance ? 10000.0 : 100.0, true},
                  .columns = {}};
  const auto w = static_cast<std::size_t>(way);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const EkfRow& row = *rows[i];
    std::vector<double> figures;
    for (const EkfErrors& errors : row.runs) figures.push_back(variance ? errors.variance : errors.mean);
    const double mean = variance ? row.mean.variance : row.mean.mean;
    PlotColumn column{.label = kLooks[i].column, .color = kLooks[i].style.color};
    if (!figures.empty())
      column.measured = ColumnSpread{mean, quantile(figures, 0.01), quantile(figures, 0.99)};
    column.published = variance ? row.sensors.published_variance[w] : row.sensors.published_mean[w];
    plot.columns.push_back(std::move(column));
  }
  return plot;
}

}  // namespace

std::string ekf_trajectories(const EkfReport& report) {
  Figure figure{
      .title = "Figure 2.2 again: trajectories of the three approaches",
      .caption =
          "One run (seed 1). The fused ways lie within decimetres of the true one, so the end of each way is "
          "shown enlarged, and the error over time on a logarithmic scale. The source gives no lengths, "
          "rates or noises: shapes can be compared, places cannot."};
  figure.legend.push_back({"true way", kTruth});
  for (std::size_t i = 0; i < kLooks.size(); ++i)
    figure.legend.push_back({std::string(kEkfSensorSets[i].name), kLooks[i].style});
  for (const EkfWay way : {EkfWay::sinus, EkfWay::circle}) {
    const std::vector<const EkfRow*> rows = placed_rows(report, way);
    if (rows.empty()) continue;
    figure.pictures.push_back(to_svg(ways_plot(rows, way, false)));
    figure.pictures.push_back(to_svg(ways_plot(rows, way, true)));
    figure.pictures.push_back(to_svg(error_plot(rows, way)));
  }
  return to_html(figure);
}

std::string ekf_statistics(const EkfReport& report) {
  Figure figure{
      .title = "Figures 2.3 and 2.4 again: ME and MSE of the approaches",
      .caption =
          "Mean error, and its variance about the mean, which the source calls MSE. The bars hold 98 % "
          "of the seeds. The published variance of the encoders alone fits no drift that starts at "
          "zero and is not judged.",
      .legend = {{"published", {}, LegendSymbol::published},
                 {"here: mean, 1 to 99 % of the seeds", {.color = kInk}, LegendSymbol::measured}},
      .columns = 2};
  for (const bool variance : {false, true}) {
    for (const EkfWay way : {EkfWay::sinus, EkfWay::circle})
      figure.pictures.push_back(to_svg(statistics_plot(placed_rows(report, way), way, variance)));
  }
  return to_html(figure);
}

std::string ekf_recorded_ways(const RealDataResults& results) {
  const PlotStyle styles[] = {{.color = kGrey}, {.color = kBlue}, {.color = kVermilion, .dash = "6 3"}};
  std::string html;
  Figure figure{.title = "Ways on the recorded logs",
                .caption = "Not of the source. East or along the reference's x is to the right.",
                .legend = {{"reference: fixes, motion capture, or survey", styles[0], LegendSymbol::dots},
                           {"filter with its sensors", styles[1]},
                           {"without a receiver, or wheels alone", styles[2]}}};
  for (const RealDataPicture& picture : results.pictures) {
    PathPlot plot{.title = picture.title.substr(0, picture.title.find(':'))};
    for (const RealDataPicture::Way& way : picture.ways) {
      const std::size_t i = plot.ways.size();
      plot.ways.push_back({styles[i % std::size(styles)], way.points, i == 0});
    }
    figure.pictures.push_back(to_svg(plot));
  }
  return figure.pictures.empty() ? "" : to_html(figure);
}

}  // namespace bw
