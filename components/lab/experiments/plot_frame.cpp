#include "components/lab/experiments/plot_frame.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "components/evaluation/axis_ticks.hpp"
#include "components/lab/experiments/plot_style.hpp"

namespace bw {
namespace {

constexpr double kLeft = 50.0, kRight = 350.0, kTop = 24.0, kFoot = 38.0;
constexpr double kRoomX = 45.0, kRoomY = 26.0;  // [px] between ticks at least
constexpr std::string_view kGrid = "stroke=\"#dde2e7\" stroke-width=\"1\"";
constexpr int kSmall = 12;

/// 0 at the low end, 1 at the high end.
double share(const PlotAxis& axis, double value) {
  if (!axis.logarithmic) return (value - axis.low) / (axis.high - axis.low);
  return std::log(std::max(value, axis.low) / axis.low) / std::log(axis.high / axis.low);
}

struct Tick {
  double value;
  std::string text;
};

std::vector<Tick> ticks_of(const PlotAxis& axis, double pixels, double room) {
  std::vector<Tick> ticks;
  if (axis.logarithmic) {
    for (const double value : decades_between(axis.low, axis.high))
      ticks.push_back({value, tick_text(value, value)});
    return ticks;
  }
  const double step = round_step(axis.low, axis.high, std::max(2, static_cast<int>(pixels / room)));
  for (const double value : ticks_between(axis.low, axis.high, step))
    ticks.push_back({value, tick_text(value, step)});
  return ticks;
}

}  // namespace

PlotFrame::PlotFrame(PlotAxis x, PlotAxis y, double height)
    : x_(std::move(x)), y_(std::move(y)), height_(height) {}

double PlotFrame::left() const { return kLeft; }
double PlotFrame::right() const { return kRight; }
double PlotFrame::top() const { return kTop; }
double PlotFrame::picture_height() const { return bottom() + kFoot; }

Vector2 PlotFrame::at(double x, double y) const {
  return {kLeft + (kRight - kLeft) * share(x_, x), bottom() - height_ * share(y_, y)};
}

std::vector<Vector2> PlotFrame::at(const std::vector<Vector2>& points) const {
  std::vector<Vector2> pixels;
  pixels.reserve(points.size());
  for (const Vector2& p : points) pixels.push_back(at(p.x(), p.y()));
  return pixels;
}

void PlotFrame::draw_title(SvgWriter& svg, const std::string& title) const {
  svg.open("<title>" + xml_text(title) + "</title>");
  svg.text({kLeft, 15.0}, title, text_style(13) + " font-weight=\"600\"");
}

void PlotFrame::draw_x(SvgWriter& svg) const {
  for (const Tick& tick : ticks_of(x_, kRight - kLeft, kRoomX)) {
    const double x = at(tick.value, y_.low).x();
    svg.line({x, kTop}, {x, bottom()}, kGrid);
    svg.text({x, bottom() + 15.0}, tick.text, text_style(kSmall, "middle"));
  }
  svg.line({kLeft, bottom()}, {kRight, bottom()}, "stroke=\"#5c6b7a\"");
  svg.text({(kLeft + kRight) / 2.0, bottom() + 32.0}, x_.label, text_style(kSmall, "middle"));
}

void PlotFrame::draw_y(SvgWriter& svg) const {
  for (const Tick& tick : ticks_of(y_, height_, kRoomY)) {
    const double y = at(x_.low, tick.value).y();
    svg.line({kLeft, y}, {kRight, y}, kGrid);
    svg.text({kLeft - 5.0, y + 4.0}, tick.text, text_style(kSmall, "end"));
  }
  svg.line({kLeft, kTop}, {kLeft, bottom()}, "stroke=\"#5c6b7a\"");
  const double middle = kTop + height_ / 2.0;
  svg.text({12.0, middle}, y_.label,
           text_style(kSmall, "middle") + " transform=\"rotate(-90 12 " + fixed(middle, 1) + ")\"");
}

void PlotFrame::open_area(SvgWriter& svg) const {
  const std::string x = fixed(kLeft, 0), y = fixed(kTop, 0);
  const std::string width = fixed(kRight - kLeft, 0), height = fixed(height_, 1);
  svg.open("<svg x=\"" + x + "\" y=\"" + y + "\" width=\"" + width + "\" height=\"" + height +
           "\" viewBox=\"" + x + ' ' + y + ' ' + width + ' ' + height + "\">");
}

void PlotFrame::close_area(SvgWriter& svg) const { svg.close("</svg>"); }

}  // namespace bw
