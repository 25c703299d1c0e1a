#include "components/lab/experiments/line_plot.hpp"

#include <utility>

#include "components/lab/experiments/thin_line.hpp"

namespace bw {
namespace {

constexpr double kUnseen = 0.25;  // [px]

void draw_span(SvgWriter& svg, const PlotFrame& frame, const PlotAxis& y, const PlotSpan& span) {
  const double from = frame.at(span.from, y.low).x();
  const double to = frame.at(span.to, y.low).x();
  svg.rectangle({from, frame.top()}, to - from, frame.bottom() - frame.top(), "fill=\"#e9edf2\"");
  svg.text({(from + to) / 2.0, frame.top() + 13.0}, span.label, text_style(12, "middle", "#4a5866"));
}

}  // namespace

void draw_limit(SvgWriter& svg, const PlotFrame& frame, const PlotLimit& limit) {
  const double y = frame.at(0.0, limit.value).y();
  svg.line({frame.left(), y}, {frame.right(), y}, stroke({.color = kInk, .dash = "4 3", .width = 1.2}));
  svg.text({frame.right() - 3.0, y - 4.0}, limit.label, text_style(11, "end"));
}

std::string to_svg(const LinePlot& plot) {
  const PlotFrame frame(plot.x, plot.y, plot.height);
  SvgWriter svg(kPlotWidth, frame.picture_height());
  frame.draw_title(svg, plot.title);
  for (const PlotSpan& span : plot.spans) draw_span(svg, frame, plot.y, span);
  frame.draw_x(svg);
  frame.draw_y(svg);
  frame.open_area(svg);
  for (const PlotCurve& curve : plot.curves)
    svg.polyline(thin_line(frame.at(curve.points), kUnseen), stroke(curve.style));
  for (const PlotLimit& limit : plot.limits) draw_limit(svg, frame, limit);
  frame.close_area(svg);
  return std::move(svg).finish();
}

}  // namespace bw
