#include "components/lab/report/strokes.hpp"

#include <algorithm>
#include <cmath>

#include "components/lab/report/thin_line.hpp"

namespace bw::report {
namespace {

using Json = nlohmann::ordered_json;

const Vector2 kSteps(800.0, 500.0);  // a picture as large as a screen shows it
constexpr double kUnseen = 0.4;      // [steps] off a line
constexpr double kApart = 3.0;       // [steps] of dots
constexpr double kFinest = 5.0;      // of a step, in which numbers are rounded

double round_to(double value, double decimals) {
  const double power = std::pow(10.0, decimals);
  return std::round(value * power) / power + 0.0;  // no zero has a sign
}

}  // namespace

Canvas::Canvas(const Chart& chart) : logarithmic_{chart.x.logarithmic, chart.y.logarithmic} {
  Eigen::AlignedBox2d all;
  const auto hold = [&](const Vector2& point) {
    if (point.allFinite()) all.extend(point);
  };
  for (const Series& series : chart.series) std::ranges::for_each(series.points, hold);
  for (const Body& body : chart.bodies) hold(body.center);
  for (const Mark& mark : chart.marks) hold(mark.at);
  if (all.isEmpty()) all.extend(Vector2(0.0, 0.0));
  const Axis* const axes[] = {&chart.x, &chart.y};
  for (int axis = 0; axis < 2; ++axis) {
    if (std::isfinite(axes[axis]->low)) all.min()[axis] = axes[axis]->low;
    if (std::isfinite(axes[axis]->high)) all.max()[axis] = axes[axis]->high;
    if (logarithmic_[axis]) {
      all.min()[axis] = std::log10(std::max(all.min()[axis], 1e-12));
      all.max()[axis] = std::log10(std::max(all.max()[axis], 1e-12));
    }
    all.max()[axis] = std::max(all.max()[axis], all.min()[axis] + 1e-9);
  }
  shown_ = all;
}

Vector2 Canvas::to_steps(const Vector2& point) const {
  Vector2 value = point;
  for (int axis = 0; axis < 2; ++axis)
    if (logarithmic_[axis])
      value[axis] = std::max(shown_.min()[axis], std::log10(std::max(point[axis], 1e-300)));
  return (value - shown_.min()).cwiseQuotient(shown_.sizes()).cwiseProduct(kSteps);
}

Vector2 Canvas::from_steps(const Vector2& steps) const {
  Vector2 value = shown_.min() + steps.cwiseQuotient(kSteps).cwiseProduct(shown_.sizes());
  for (int axis = 0; axis < 2; ++axis)
    if (logarithmic_[axis]) value[axis] = std::pow(10.0, value[axis]);
  return value;
}

bool Canvas::is_seen(const Vector2& steps) const {
  return (steps.array() >= -kSteps.array()).all() && (steps.array() <= 2.0 * kSteps.array()).all();
}

double Canvas::rounded(double value, int axis) const {
  if (!std::isfinite(value)) return value;
  const double step =
      logarithmic_[axis] ? std::abs(value) / kSteps[axis] : shown_.sizes()[axis] / kSteps[axis];
  return step > 0.0 ? round_to(value, std::clamp(std::ceil(-std::log10(step / kFinest)), 0.0, 12.0)) : value;
}

Json Canvas::flat(const std::vector<Vector2>& points) const {
  Json list = Json::array();
  for (const Vector2& point : points) {
    list.push_back(rounded(point.x(), 0));
    list.push_back(rounded(point.y(), 1));
  }
  return list;
}

Json Canvas::strokes(const Series& series) const {
  Json all = Json::array();
  std::vector<Vector2> piece;
  const auto finish = [&] {
    std::vector<Vector2> kept = series.dots ? thin_dots(piece, kApart) : thin_line(piece, kUnseen);
    for (Vector2& point : kept) point = from_steps(point);
    if (!kept.empty()) all.push_back(flat(kept));
    piece.clear();
  };
  for (std::size_t i = 0; i < series.points.size(); ++i) {
    const auto seen = [&](std::size_t k) {
      return k < series.points.size() && series.points[k].allFinite() && is_seen(to_steps(series.points[k]));
    };
    // The neighbours of what is seen stay: lines come in and go out.
    if (series.points[i].allFinite() && (seen(i) || seen(i + 1) || (i > 0 && seen(i - 1)))) {
      piece.push_back(to_steps(series.points[i]));
    } else {
      finish();
    }
  }
  finish();
  return all;
}

}  // namespace bw::report
