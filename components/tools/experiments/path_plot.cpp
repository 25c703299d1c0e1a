#include "components/tools/experiments/path_plot.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "components/evaluation/svg_writer.hpp"

namespace bw {
namespace {

constexpr double kWidth = 560.0, kMost = 560.0;  // of the drawing [px]
constexpr double kMargin = 16.0, kHead = 26.0, kFoot = 44.0;
constexpr std::string_view kSmall = R"(font-size="11" fill="#444")";

/// 1, 2 or 5 times a power of ten, not above a quarter of the width shown.
double scale_bar(double metres_shown) {
  const double power = std::pow(10.0, std::floor(std::log10(metres_shown / 4.0)));
  const double digits = metres_shown / 4.0 / power;
  return power * (digits >= 5.0 ? 5.0 : digits >= 2.0 ? 2.0 : 1.0);
}

}  // namespace

std::string path_plot(const std::string& title, const std::vector<PlotWay>& ways) {
  Eigen::AlignedBox2d box;
  for (const PlotWay& way : ways) {
    for (const Vector2& p : way.points) box.extend(p);
  }
  if (box.isEmpty()) box.extend(Vector2(0.0, 0.0));
  const Vector2 extent = box.sizes().cwiseMax(1e-3);
  const double scale = std::min((kWidth - 2.0 * kMargin) / extent.x(), kMost / extent.y());  // [px/m]
  const double bottom = kHead + scale * extent.y();
  const auto at = [&](const Vector2& p) {
    return Vector2(kMargin + scale * (p.x() - box.min().x()), bottom - scale * (p.y() - box.min().y()));
  };
  SvgWriter svg(kWidth, bottom + kFoot);
  svg.text({kMargin, 14.0}, title, std::string(kSmall) + R"( font-weight="bold")");
  for (const PlotWay& way : ways) {
    std::vector<Vector2> pixels;
    for (const Vector2& p : way.points) pixels.push_back(at(p));
    if (way.dots) {
      for (const Vector2& p : pixels) svg.circle(p, 1.3, R"(fill=")" + way.color + '"');
    } else {
      svg.polyline(pixels, R"(stroke-width="1.5" stroke=")" + way.color + '"');
    }
  }
  const double bar = scale_bar((kWidth - 2.0 * kMargin) / scale);
  const Vector2 left(kMargin, bottom + 14.0);
  svg.line(left, left + Vector2(bar * scale, 0.0), R"(stroke="#444" stroke-width="2")");
  svg.text(left + Vector2(bar * scale + 6.0, 4.0), fixed(bar, bar < 1.0 ? 1 : 0) + " m", kSmall);
  Vector2 legend(kMargin, bottom + 36.0);
  for (const PlotWay& way : ways) {
    svg.line(legend + Vector2(0.0, -4.0), legend + Vector2(18.0, -4.0),
             R"(stroke-width="2" stroke=")" + way.color + '"');
    svg.text(legend + Vector2(22.0, 0.0), way.label, kSmall);
    legend.x() += 150.0;
  }
  return std::move(svg).finish();
}

}  // namespace bw
