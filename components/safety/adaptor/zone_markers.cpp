#include "components/safety/adaptor/zone_markers.hpp"

#include <string>
#include <utility>
#include <vector>

#include "components/messages/geometry.hpp"
#include "components/messages/markers.hpp"
#include "components/model/footprint_outline.hpp"

namespace bw::safety {
namespace {

using visualization_msgs::msg::Marker;
namespace constants = visualization_msgs::msg::Marker_Constants;

constexpr Color kFree{0.1F, 0.7F, 0.2F, 0.9F};
constexpr Color kLimited{0.95F, 0.7F, 0.1F, 0.9F};
constexpr Color kStopped{0.85F, 0.1F, 0.1F, 0.9F};
constexpr Color kIdle{0.5F, 0.5F, 0.5F, 0.9F};

Color color_of(Action action) {
  if (action == Action::do_nothing) return kFree;
  return action == Action::stop ? kStopped : kLimited;
}

Marker marker(const std::string& ns, int id, int type, const Color& color,
              const std_msgs::msg::Header& header) {
  Marker m = make_marker(ns, id, type, Duration::milliseconds(1000), header);
  m.scale().x(0.02);
  paint(m, color);
  return m;
}

std::vector<geometry_msgs::msg::Point> closed(const std::vector<Vector2>& corners) {
  std::vector<geometry_msgs::msg::Point> points;
  for (const Vector2& corner : corners) points.push_back(to_point(corner));
  points.push_back(points.front());
  return points;
}

std::vector<geometry_msgs::msg::Point> line_around(const Footprint& footprint) {
  constexpr int kCornersOfDisc = 48;
  return closed(outline(footprint, {}, kCornersOfDisc));
}

std::vector<geometry_msgs::msg::Point> line_around(const ZoneOptions& zone) {
  if (zone.type == ZoneShape::circle) return line_around(Footprint{.radius = zone.radius, .polygon = {}});
  std::vector<Vector2> corners;
  for (const CornerOptions& corner : zone.points) corners.emplace_back(corner.x, corner.y);
  return closed(corners);
}

}  // namespace

visualization_msgs::msg::MarkerArray to_markers(const CollisionMonitorOptions& options,
                                                const Footprint& kept_free, const Verdict& verdict,
                                                const std_msgs::msg::Header& header) {
  visualization_msgs::msg::MarkerArray array;
  const Color color = color_of(verdict.action);
  Marker robot = marker("footprint", 0, constants::LINE_STRIP, color, header);
  robot.points(line_around(kept_free));
  array.markers().push_back(std::move(robot));
  if (!verdict.cause.empty()) {
    Marker text = marker("footprint", 1, constants::TEXT_VIEW_FACING, color, header);
    text.pose().position().z(0.5);
    text.scale().z(0.15);
    text.text(std::string(verdict.cause));
    array.markers().push_back(std::move(text));
  }
  int id = 0;
  for (const ZoneOptions& zone : options.polygons) {
    if (!zone.enabled) continue;
    Marker line =
        marker("zones", id++, constants::LINE_STRIP, zone.name == verdict.cause ? color : kIdle, header);
    line.points(line_around(zone));
    array.markers().push_back(std::move(line));
  }
  return array;
}

}  // namespace bw::safety
