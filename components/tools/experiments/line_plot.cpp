#include "components/tools/experiments/line_plot.hpp"

#include <algorithm>
#include <cmath>

#include "components/evaluation/svg_writer.hpp"

namespace bw {
namespace {

constexpr double kWidth = 460.0, kHeight = 240.0;
constexpr double kLeft = 44.0, kRight = 450.0, kTop = 24.0, kBottom = 204.0;  // of the axes
constexpr int kTicksY = 4;
constexpr double kTickTime = 5.0;  // [s]
constexpr std::string_view kGrid = R"(stroke="#ddd" stroke-width="1")";
constexpr std::string_view kSmall = R"(font-size="11" fill="#444")";

std::string with(std::string_view style, std::string_view more) {
  return std::string(style) + " " + std::string(more);
}

}  // namespace

std::string to_svg(const LinePlot& plot) {
  double last = kTickTime;
  for (const PlotCurve& curve : plot.curves) {
    for (const Vector2& p : curve.points) last = std::max(last, p.x());
  }
  const auto at = [&](double time, double value) {
    return Vector2(kLeft + (kRight - kLeft) * time / last,
                   kBottom - (kBottom - kTop) * std::clamp(value / plot.y_max, 0.0, 1.0));
  };
  SvgWriter svg(kWidth, kHeight);
  svg.text({kLeft, 14.0}, plot.title, with(kSmall, R"(font-weight="bold")"));
  for (int i = 0; i <= kTicksY; ++i) {
    const double value = plot.y_max * i / kTicksY;
    svg.line(at(0.0, value), at(last, value), kGrid);
    svg.text(at(0.0, value) + Vector2(-6.0, 4.0), fixed(value, 2), with(kSmall, R"(text-anchor="end")"));
  }
  for (double time = 0.0; time <= last; time += kTickTime) {
    svg.line(at(time, 0.0), at(time, plot.y_max), kGrid);
    svg.text(at(time, 0.0) + Vector2(0.0, 14.0), fixed(time, 0), with(kSmall, R"(text-anchor="middle")"));
  }
  svg.text({kRight, 14.0}, plot.y_label + " over time [s]", with(kSmall, R"(text-anchor="end")"));
  Vector2 legend(kLeft, kHeight - 6.0);
  for (const PlotCurve& curve : plot.curves) {
    std::vector<Vector2> pixels;
    for (const Vector2& p : curve.points) pixels.push_back(at(p.x(), p.y()));
    const std::string stroke = R"(stroke-width="1.6" stroke=")" + curve.color + '"';
    svg.polyline(pixels, stroke);
    svg.line(legend + Vector2(0.0, -4.0), legend + Vector2(18.0, -4.0), stroke);
    svg.text(legend + Vector2(22.0, 0.0), curve.label, kSmall);
    legend.x() += 130.0;
  }
  return std::move(svg).finish();
}

}  // namespace bw
