#include "components/safety/adaptor/zone_markers.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "components/messages/geometry.hpp"
#include "components/messages/markers.hpp"

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

std::vector<geometry_msgs::msg::Point> circle(double radius) {
  constexpr int kCorners = 48;
  std::vector<geometry_msgs::msg::Point> points;
  for (int i = 0; i <= kCorners; ++i)
    points.push_back(to_point(radius * direction(2.0 * std::numbers::pi * i / kCorners)));
  return points;
}

std::vector<geometry_msgs::msg::Point> outline(const ZoneOptions& zone) {
  if (zone.type == ZoneShape::circle) return circle(zone.radius);
  std::vector<geometry_msgs::msg::Point> points;
  for (const CornerOptions& corner : zone.points) points.push_back(to_point(Vector2(corner.x, corner.y)));
  points.push_back(points.front());
  return points;
}

}  // namespace

visualization_msgs::msg::MarkerArray to_markers(const CollisionMonitorOptions& options, double robot_radius,
                                                const Verdict& verdict, const std_msgs::msg::Header& header) {
  visualization_msgs::msg::MarkerArray array;
  const Color color = color_of(verdict.action);
  Marker disc = marker("footprint", 0, constants::LINE_STRIP, color, header);
  disc.points(circle(robot_radius + options.stopping.padding));
  array.markers().push_back(std::move(disc));
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
    line.points(outline(zone));
    array.markers().push_back(std::move(line));
  }
  return array;
}

}  // namespace bw::safety
