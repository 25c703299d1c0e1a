#include "components/local_planner/adaptor/marker_drawing.hpp"

#include <algorithm>
#include <cmath>

namespace bw {
namespace {

using visualization_msgs::msg::Marker;
namespace constants = visualization_msgs::msg::Marker_Constants;

bool has_position(const geometry_msgs::msg::Point& p) {
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

}  // namespace

MarkerDrawing::MarkerDrawing(std_msgs::msg::Header header) : header_(std::move(header)) {
  Marker clear;
  clear.header(header_);
  clear.action(constants::DELETEALL);
  array_.markers().push_back(std::move(clear));
}

Marker MarkerDrawing::make(const std::string& ns, std::int32_t type, double size, const Color& color) {
  Marker marker = make_marker(ns, id_++, type, {}, header_);
  marker.scale().x(size);
  marker.scale().y(size);
  marker.scale().z(size);
  paint(marker, color);
  return marker;
}

void MarkerDrawing::add(Marker marker) {
  const bool drawable = has_position(marker.pose().position()) &&
                        std::isfinite(marker.pose().orientation().z()) && std::isfinite(marker.scale().x()) &&
                        std::isfinite(marker.scale().y()) &&
                        std::all_of(marker.points().begin(), marker.points().end(), has_position);
  if (drawable) array_.markers().push_back(std::move(marker));
}

}  // namespace bw
