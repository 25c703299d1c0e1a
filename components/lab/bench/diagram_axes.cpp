#include "components/lab/bench/diagram_axes.hpp"

#include "components/evaluation/axis_ticks.hpp"

namespace bw {
namespace {

constexpr double kWide = 600.0;  // from here on there is room for more ticks [px]

void draw_ticks_h(SvgWriter& svg, const DiagramAxes& axes) {
  const double step = round_step(axes.h.low, axes.h.high, axes.width > kWide ? 14 : 8);
  for (const double x : ticks_between(axes.h.low, axes.h.high, step)) {
    const Vector2 foot = axes.at(x, axes.v.low);
    svg.line(foot, axes.at(x, axes.v.high), R"(stroke="#e4e4e4")");
    svg.text(foot + Vector2(0, 16), tick_text(x, step), R"(font-size="12" text-anchor="middle")");
  }
}

void draw_ticks_v(SvgWriter& svg, const DiagramAxes& axes) {
  const double step = round_step(axes.v.low, axes.v.high, 8);
  for (const double y : ticks_between(axes.v.low, axes.v.high, step)) {
    const Vector2 foot = axes.at(axes.h.low, y);
    svg.line(foot, axes.at(axes.h.high, y), R"(stroke="#e4e4e4")");
    svg.text(foot + Vector2(-6, 4), tick_text(y, step), R"(font-size="12" text-anchor="end")");
  }
}

}  // namespace

void DiagramAxes::draw(SvgWriter& svg, const std::string& name_h, const std::string& name_v,
                       bool has_ticks_v) const {
  draw_ticks_h(svg, *this);
  if (has_ticks_v) draw_ticks_v(svg, *this);
  svg.rectangle(corner, width, height, R"(fill="none" stroke="#444")");
  svg.text(corner + Vector2(width / 2, height + 33), name_h, R"(font-size="13" text-anchor="middle")");
  svg.text(corner + Vector2(0, -6), name_v, R"(font-size="13")");
}

}  // namespace bw
