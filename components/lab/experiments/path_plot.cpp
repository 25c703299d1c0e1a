#include "components/lab/experiments/path_plot.hpp"

#include <utility>

#include "components/evaluation/picture_view.hpp"
#include "components/lab/experiments/plot_frame.hpp"
#include "components/lab/experiments/thin_line.hpp"

namespace bw {
namespace {

constexpr double kUnseen = 0.25;                    // [px]
constexpr double kApart = 2.5;                      // [px] of dots
constexpr double kRoom = 0.04;                      // about what is shown, of its size
constexpr double kFlattest = 0.3, kSteepest = 1.0;  // height over width
constexpr double kRoomForLabel = 7.0;               // [px] radius of a disc
constexpr std::string_view kWall = "#34414f";

void widen(Eigen::AlignedBox2d& box, int axis, double size) {
  const double missing = size - box.sizes()[axis];
  if (missing <= 0.0) return;
  box.min()[axis] -= missing / 2.0;
  box.max()[axis] += missing / 2.0;
}

void draw_disc(SvgWriter& svg, const PlotFrame& frame, const PlotDisc& disc, double scale) {
  const Vector2 at = frame.at(disc.center.x(), disc.center.y());
  const std::string color(disc.color);
  svg.circle(at, disc.radius * scale,
             "fill=\"" + color + "\" fill-opacity=\"0.15\" stroke=\"" + color + "\" stroke-width=\"1.2\"");
  if (disc.arrow != Vector2(0.0, 0.0)) {
    const Vector2 tip = frame.at(disc.center.x() + disc.arrow.x(), disc.center.y() + disc.arrow.y());
    const Vector2 back = (at - tip).normalized() * 5.0;
    const Vector2 aside(-back.y() / 2.0, back.x() / 2.0);
    svg.line(at, tip, stroke({.color = disc.color, .width = 1.4}));
    svg.polyline({tip + back + aside, tip, tip + back - aside}, stroke({.color = disc.color, .width = 1.4}));
  }
  if (disc.label.empty()) return;
  const double radius = disc.radius * scale;
  const double down = radius < kRoomForLabel ? -radius - 2.0 : 3.5;  // above it where it has no room
  svg.text(at + Vector2(0.0, down), disc.label, text_style(10, "middle"));
}

void draw_place(SvgWriter& svg, const PlotFrame& frame, const PathPlot& plot, const PictureView& view) {
  for (const std::vector<Vector2>& area : plot.areas) {
    std::string data;
    for (const Vector2& p : frame.at(area))
      data += (data.empty() ? 'M' : 'L') + fixed(p.x(), 1) + ' ' + fixed(p.y(), 1);
    svg.path(data + "Z", "fill=\"#dfe5ec\"");
  }
  if (plot.map != nullptr)
    svg.path(cells_path(*plot.map, view, 65, 100), "fill=\"" + std::string(kWall) + '"');
  for (const Segment& wall : plot.walls)
    svg.line(frame.at(wall.a.x(), wall.a.y()), frame.at(wall.b.x(), wall.b.y()),
             stroke({.color = kWall, .width = 2.5}));
}

}  // namespace

Eigen::AlignedBox2d shown_by(const PathPlot& plot) {
  Eigen::AlignedBox2d box = plot.view;
  if (box.isEmpty()) {
    for (const PlotWay& way : plot.ways) {
      for (const Vector2& p : way.points) {
        if (p.allFinite()) box.extend(p);
      }
    }
    for (const PlotDisc& disc : plot.discs) {
      box.extend(disc.center - Vector2::Constant(disc.radius));
      box.extend(disc.center + Vector2::Constant(disc.radius));
    }
    if (box.isEmpty()) box.extend(Vector2(0.0, 0.0));
    const double room = kRoom * box.sizes().maxCoeff();
    box.min().array() -= room;
    box.max().array() += room;
  }
  widen(box, 0, 1e-3);
  widen(box, 1, box.sizes().x() * kFlattest);
  widen(box, 0, box.sizes().y() / kSteepest);
  return box;
}

std::string to_svg(const PathPlot& plot) {
  const Eigen::AlignedBox2d box = shown_by(plot);
  const PlotAxis x{"x [m]", box.min().x(), box.max().x()};
  const PlotAxis y{"y [m]", box.min().y(), box.max().y()};
  const PlotFrame at_width(x, y, 1.0);
  const double scale = (at_width.right() - at_width.left()) / box.sizes().x();  // [px/m]
  const PlotFrame frame(x, y, scale * box.sizes().y());
  SvgWriter svg(kPlotWidth, frame.picture_height());
  frame.draw_title(svg, plot.title);
  frame.draw_x(svg);
  frame.draw_y(svg);
  frame.open_area(svg);
  draw_place(svg, frame, plot, {box, scale, {frame.left(), frame.top()}});
  for (const PlotWay& way : plot.ways) {
    const std::vector<Vector2> pixels = frame.at(way.points);
    if (way.dots) {
      for (const Vector2& p : thin_dots(pixels, kApart))
        svg.circle(p, 1.4, "fill=\"" + std::string(way.style.color) + '"');
    } else {
      svg.polyline(thin_line(pixels, kUnseen), stroke(way.style));
    }
  }
  for (const PlotDisc& disc : plot.discs) draw_disc(svg, frame, disc, scale);
  frame.close_area(svg);
  return std::move(svg).finish();
}

}  // namespace bw
