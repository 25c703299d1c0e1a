#include "components/lab/experiments/column_plot.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bw {
namespace {

/// The middle of column `index`, with columns at 0.5, 1.5, ...
double middle(std::size_t index) { return static_cast<double>(index) + 0.5; }

void draw_runs(SvgWriter& svg, const PlotFrame& frame, const ColumnPlot& plot, std::size_t index) {
  const PlotColumn& column = plot.columns[index];
  const auto count = static_cast<double>(column.runs.size());
  for (std::size_t i = 0; i < column.runs.size(); ++i) {
    if (!std::isfinite(column.runs[i])) continue;
    const double aside = (static_cast<double>(i) + 0.5) / count - 0.5;
    const double value = std::clamp(column.runs[i], plot.y.low, plot.y.high);
    svg.circle(frame.at(middle(index) + 0.6 * aside, value), 2.2,
               "fill=\"" + std::string(column.color) + "\" fill-opacity=\"0.55\"");
  }
}

void draw_measured(SvgWriter& svg, const PlotFrame& frame, const ColumnPlot& plot, std::size_t index) {
  const PlotColumn& column = plot.columns[index];
  if (!column.measured || !std::isfinite(column.measured->mean)) return;
  const auto at = [&](double value) {
    return frame.at(middle(index) + 0.1, std::clamp(value, plot.y.low, plot.y.high));
  };
  const Vector2 low = at(column.measured->low), high = at(column.measured->high);
  const std::string line = stroke({.color = column.color, .width = 1.6});
  svg.line(low, high, line);
  for (const Vector2& end : {low, high}) svg.line(end - Vector2(4.0, 0.0), end + Vector2(4.0, 0.0), line);
  svg.circle(at(column.measured->mean), 4.0, "fill=\"" + std::string(column.color) + '"');
}

void draw_published(SvgWriter& svg, const PlotFrame& frame, const ColumnPlot& plot, std::size_t index) {
  const PlotColumn& column = plot.columns[index];
  if (!column.published) return;
  const Vector2 at = frame.at(middle(index) - 0.1, std::clamp(*column.published, plot.y.low, plot.y.high));
  const double r = 5.0;
  svg.polyline({at + Vector2(0.0, -r), at + Vector2(r, 0.0), at + Vector2(0.0, r), at + Vector2(-r, 0.0),
                at + Vector2(0.0, -r)},
               stroke({.width = 1.6}));
}

}  // namespace

std::string to_svg(const ColumnPlot& plot) {
  const double count = std::max(1.0, static_cast<double>(plot.columns.size()));
  const PlotFrame frame({"", 0.0, count}, plot.y, plot.height);
  SvgWriter svg(kPlotWidth, frame.bottom() + 22.0);
  frame.draw_title(svg, plot.title);
  frame.draw_y(svg);
  svg.line({frame.left(), frame.bottom()}, {frame.right(), frame.bottom()}, "stroke=\"#5c6b7a\"");
  for (const PlotLimit& limit : plot.limits) draw_limit(svg, frame, limit);
  for (std::size_t i = 0; i < plot.columns.size(); ++i) {
    draw_runs(svg, frame, plot, i);
    draw_measured(svg, frame, plot, i);
    draw_published(svg, frame, plot, i);
    svg.text({frame.at(middle(i), plot.y.low).x(), frame.bottom() + 15.0}, plot.columns[i].label,
             text_style(12, "middle"));
  }
  return std::move(svg).finish();
}

}  // namespace bw
