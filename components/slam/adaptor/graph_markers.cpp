#include "components/slam/adaptor/graph_markers.hpp"

#include <algorithm>

#include "components/messages/markers.hpp"

namespace bw::slam {
namespace {

using visualization_msgs::msg::Marker;
using visualization_msgs::msg::MarkerArray;
namespace constants = visualization_msgs::msg::Marker_Constants;

constexpr Color kNode{0.34F, 0.71F, 0.91F, 1.0F};
constexpr Color kDrive{0.55F, 0.60F, 0.65F, 1.0F};
constexpr Color kGood{0.0F, 0.62F, 0.45F, 1.0F};
constexpr Color kStrained{0.90F, 0.62F, 0.0F, 1.0F};
constexpr Color kBad{0.84F, 0.37F, 0.0F, 1.0F};

Color between(const Color& a, const Color& b, double share) {
  Color color{};
  for (std::size_t i = 0; i < color.size(); ++i)
    color[i] = a[i] + static_cast<float>(std::clamp(share, 0.0, 1.0)) * (b[i] - a[i]);
  return color;
}

// By the share of its weight that a loop keeps in the graph: all of it, a half, none.
Color color_of(double weight) {
  return weight > 0.5 ? between(kStrained, kGood, 2.0 * weight - 1.0)
                      : between(kBad, kStrained, 2.0 * weight);
}

}  // namespace

MarkerArray to_markers(const Slam& slam, const Pose2& X_MW, const std::string& frame, Time stamp) {
  const std_msgs::msg::Header header = make_header(frame, stamp);
  const auto marker = [&](const char* name_space, std::int32_t type, double size, const Color& color) {
    Marker made = make_marker(name_space, 0, type, {}, header);
    made.scale().x(size);
    made.scale().y(size);
    made.scale().z(size);
    paint(made, color);
    return made;
  };
  MarkerArray array;
  array.markers().push_back(make_marker("slam_toolbox", 0, constants::SPHERE_LIST, {}, header));
  array.markers().back().action(constants::DELETEALL);
  const std::vector<Pose2>& X_WS = slam.X_MS();
  if (X_WS.empty()) return array;
  Marker nodes = marker("slam_toolbox", constants::SPHERE_LIST, 0.15, kNode);
  Marker drive = marker("slam_toolbox_edges", constants::LINE_LIST, 0.04, kDrive);
  Marker loops = marker("slam_toolbox_loops", constants::LINE_LIST, 0.06, kGood);
  const auto point = [&](std::size_t submap) { return to_point((X_MW * X_WS[submap]).position()); };
  for (std::size_t k = 0; k < X_WS.size(); ++k)
    if (!slam.map()[k].marginalised) nodes.points().push_back(point(k));
  for (const Edge& edge : slam.edges()) {
    Marker& lines = edge.loop ? loops : drive;
    for (const std::size_t end : {edge.from, edge.to}) {
      lines.points().push_back(point(end));
      if (edge.loop) lines.colors().push_back(to_color(color_of(weight_left(edge, X_WS))));
    }
  }
  array.markers().push_back(std::move(nodes));
  // A list without points is an error to rviz.
  for (Marker* lines : {&drive, &loops})
    if (!lines->points().empty()) array.markers().push_back(std::move(*lines));
  return array;
}

}  // namespace bw::slam
