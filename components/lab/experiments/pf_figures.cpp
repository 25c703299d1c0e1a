#include "components/lab/experiments/pf_figures.hpp"

#include <algorithm>
#include <cmath>

#include "components/evaluation/axis_ticks.hpp"
#include "components/lab/experiments/column_plot.hpp"
#include "components/lab/experiments/figure.hpp"
#include "components/lab/experiments/path_plot.hpp"

namespace bw {
namespace {

constexpr double kRoofHalfWidth = 3.0;  // [m] as drawn; nothing in the experiment has this width
const PlotStyle kTruth{.color = kInk, .width = 1.2};
const PlotStyle kEncoder{.color = kVermilion, .dash = "5 2", .width = 1.3};
const PlotStyle kFilter{.color = kBlue, .width = 1.8};

std::string case_name(std::size_t row) {
  constexpr const char* kCases[] = {"(a) [x, y, θ] under the roof", "(b) [x, y] under the roof",
                                    "(c) [θ] under the roof", "(d) nothing under the roof"};
  return kCases[row];
}

const PfCell& cell_of(const PfTable& table, std::size_t row, PfMethod method) {
  return table.cells[row][static_cast<std::size_t>(method)];
}

/// Outline of the roof, along the true way.
std::vector<Vector2> roof(const std::vector<PfSample>& samples) {
  std::vector<Vector2> outline, back;
  for (std::size_t i = 10; i < samples.size(); i += 10) {
    if (samples[i].time < kPfRoofFrom || samples[i].time > kPfRoofTo) continue;
    const Vector2 along = (samples[i].truth - samples[i - 10].truth).normalized();
    const Vector2 left = kRoofHalfWidth * Vector2(-along.y(), along.x());
    outline.push_back(samples[i].truth + left);
    back.push_back(samples[i].truth - left);
  }
  outline.insert(outline.end(), back.rbegin(), back.rend());
  return outline;
}

std::vector<Vector2> estimates(const PfCell& cell) {
  std::vector<Vector2> points;
  for (const PfSample& sample : cell.example) points.push_back(sample.estimate);
  return points;
}

std::vector<Vector2> errors(const PfCell& cell) {
  std::vector<Vector2> points;
  for (const PfSample& sample : cell.example)
    points.emplace_back(sample.time, (sample.estimate - sample.truth).norm());
  return points;
}

std::vector<LegendEntry> legend() {
  return {{"true way", kTruth},
          {"encoder: last fix, then wheels", kEncoder},
          {"particle filter, Gaussian weights", kFilter},
          {"under the roof", {.color = "#dfe5ec"}, LegendSymbol::area}};
}

}  // namespace

std::string pf_ways(const PfTable& table) {
  Figure figure{
      .title = "Figure 2.5 again: the way in three parts, before, under and after the roof",
      .caption =
          "One run (the first seed), the same motion and noise in all four cases. From (0, 0) to the "
          "right and round; outside the roof all readings arrive. The source gives neither the "
          "length of the way nor where the roof stands: both are proposals.",
      .legend = legend(),
      .columns = 2};
  for (std::size_t row = 0; row < kPfRows.size(); ++row) {
    PathPlot plot{.title = case_name(row)};
    plot.areas.push_back(roof(cell_of(table, row, PfMethod::gaussian).example));
    std::vector<Vector2> truth;
    for (const PfSample& sample : cell_of(table, row, PfMethod::gaussian).example)
      truth.push_back(sample.truth);
    plot.ways = {{kEncoder, estimates(cell_of(table, row, PfMethod::encoder))},
                 {kFilter, estimates(cell_of(table, row, PfMethod::gaussian))},
                 {kTruth, truth}};
    figure.pictures.push_back(to_svg(plot));
  }
  return to_html(figure);
}

std::string pf_errors_over_time(const PfTable& table) {
  Figure figure{
      .title = "Error over time of the same runs",
      .caption =
          "Distance of the estimate from the true place. Once out of the roof the filter comes back "
          "to the true pose.",
      .legend = legend(),
      .columns = 2};
  figure.legend.erase(figure.legend.begin());
  double largest = 0.0;
  for (const auto& row : table.cells) {
    for (const PfMethod method : {PfMethod::encoder, PfMethod::gaussian}) {
      for (const Vector2& p : errors(row[static_cast<std::size_t>(method)]))
        largest = std::max(largest, p.y());
    }
  }
  for (std::size_t row = 0; row < kPfRows.size(); ++row) {
    LinePlot plot{.title = case_name(row),
                  .x = {"time [s]", 0.0, 84.0},
                  .y = {"error [m]", 0.0, round_end(largest)},
                  .spans = {{kPfRoofFrom, kPfRoofTo, "roof"}}};
    plot.curves = {{kEncoder, errors(cell_of(table, row, PfMethod::encoder))},
                   {kFilter, errors(cell_of(table, row, PfMethod::gaussian))}};
    figure.pictures.push_back(to_svg(plot));
  }
  return to_html(figure);
}

std::string pf_statistics(const PfTable& table) {
  Figure figure{
      .title = "Table 2.1 as a picture: mean error over the run",
      .caption = "What was received under the roof stands below each column. Bars hold 90 % of the seeds.",
      .legend = {{"published", {}, LegendSymbol::published},
                 {"here: mean, 5 to 95 % of the seeds", {.color = kInk}, LegendSymbol::measured}},
      .columns = 2};
  constexpr const char* kNames[] = {"[x, y, θ]", "[x, y]", "[θ]", "nothing"};
  for (const PfMethod method : {PfMethod::encoder, PfMethod::gaussian}) {
    const bool encoder = method == PfMethod::encoder;
    ColumnPlot plot{.title = encoder ? "Encoder-based odometry" : "Proposed: particle filter",
                    .y = {"mean error [m]", 0.0, encoder ? 1.6 : 0.8},
                    .columns = {}};
    for (std::size_t row = 0; row < kPfRows.size(); ++row) {
      const PfCell& cell = cell_of(table, row, method);
      plot.y.high = std::max(plot.y.high, round_end(cell.high));
      plot.columns.push_back(
          {.label = kNames[row],
           .color = encoder ? kVermilion : kBlue,
           .measured = ColumnSpread{cell.mean, cell.low, cell.high},
           .published = encoder ? kPfRows[row].published_encoder : kPfRows[row].published_proposed});
    }
    figure.pictures.push_back(to_svg(plot));
  }
  return to_html(figure);
}

}  // namespace bw
