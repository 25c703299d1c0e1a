#include "components/lab/report/chart.hpp"

#include <cmath>
#include <utility>

#include "components/lab/report/strokes.hpp"

namespace bw::report {
namespace {

using Json = nlohmann::ordered_json;

void put(Json& json, const char* key, const std::string& text) {
  if (!text.empty()) json[key] = text;
}

Json to_json(const Axis& axis) {
  Json json = Json::object();
  put(json, "label", axis.label);
  if (std::isfinite(axis.low)) json["low"] = axis.low;
  if (std::isfinite(axis.high)) json["high"] = axis.high;
  if (axis.logarithmic) json["log"] = true;
  return json;
}

Json to_json(const Series& series, const Canvas& canvas) {
  Json json = {{"color", series.look.color}, {"strokes", canvas.strokes(series)}};
  put(json, "name", series.name);
  if (series.look.dash != Dash::none) json["dash"] = series.look.dash;
  if (series.look.width != Look{}.width) json["width"] = series.look.width;
  if (series.look.opacity != Look{}.opacity) json["opacity"] = series.look.opacity;
  if (series.dots) json["dots"] = true;
  return json;
}

Json to_json(const Body& body, const Canvas& canvas) {
  Json json = {{"at", canvas.flat({body.center})}, {"radius", body.radius}, {"color", body.color}};
  put(json, "label", body.label);
  put(json, "name", body.name);
  if (body.arrow != Vector2(0.0, 0.0)) json["arrow"] = canvas.flat({body.arrow});
  return json;
}

Json to_json(const Mark& mark, const Canvas& canvas) {
  Json json = {{"at", canvas.flat({mark.at})}, {"symbol", mark.symbol}, {"color", mark.color}};
  put(json, "label", mark.label);
  put(json, "name", mark.name);
  return json;
}

Json to_json(const Area& area, const Canvas& canvas) {
  Json json = {{"outline", canvas.flat(area.outline)}, {"color", area.color}};
  put(json, "name", area.name);
  if (area.dash != Dash::none) json["dash"] = area.dash;
  if (area.is_shade) json["shade"] = true;
  return json;
}

Json to_json(const Span& span, const Canvas& /*canvas*/) {
  return {{"from", span.from}, {"to", span.to}, {"label", span.label}};
}

Json to_json(const Limit& limit, const Canvas& /*canvas*/) {
  return {{"value", limit.value}, {"label", limit.label}};
}

Json to_json(const Segment& wall, const Canvas& canvas) { return canvas.flat({wall.a, wall.b}); }

Json to_json(const Eigen::AlignedBox2d& box, const Canvas& canvas) {
  return canvas.flat({box.min(), box.max()});
}

template <class Part>
void put_all(Json& json, const char* key, const std::vector<Part>& parts, const Canvas& canvas) {
  for (const Part& part : parts) json[key].push_back(to_json(part, canvas));
}

}  // namespace

void Chart::show(const Eigen::AlignedBox2d& view) {
  x.low = view.min().x();
  x.high = view.max().x();
  y.low = view.min().y();
  y.high = view.max().y();
}

Chart floor_plan(std::string title) {
  return {.title = std::move(title), .x = {"x [m]"}, .y = {"y [m]"}, .is_floor = true};
}

Json to_json(const Chart& chart) {
  const Canvas canvas(chart);
  Json json = {{"kind", "chart"}, {"title", chart.title}, {"x", to_json(chart.x)}, {"y", to_json(chart.y)}};
  if (chart.is_floor) json["floor"] = true;
  if (chart.height > 0.0) json["height"] = chart.height;
  put_all(json, "series", chart.series, canvas);
  put_all(json, "spans", chart.spans, canvas);
  put_all(json, "limits", chart.limits, canvas);
  put_all(json, "bodies", chart.bodies, canvas);
  put_all(json, "marks", chart.marks, canvas);
  put_all(json, "areas", chart.areas, canvas);
  put_all(json, "walls", chart.walls, canvas);
  put_all(json, "blocks", chart.blocks, canvas);
  return json;
}

}  // namespace bw::report
