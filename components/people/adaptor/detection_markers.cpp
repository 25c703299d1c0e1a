#include "components/people/adaptor/detection_markers.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "components/messages/geometry.hpp"
#include "components/messages/markers.hpp"

namespace bw::people {
namespace {

constexpr double kWidestShown = 1.0;  // of a detection [m]
constexpr double kLegHeight = 0.3;    // [m]

}  // namespace

visualization_msgs::msg::MarkerArray to_markers(const DetectionSet& detections, Duration lifetime,
                                                const std_msgs::msg::Header& header) {
  namespace constants = visualization_msgs::msg::Marker_Constants;
  visualization_msgs::msg::MarkerArray array;
  const std::string legs = detections.source == 0 ? "legs" : "legs_" + std::to_string(detections.source);
  std::int32_t id = 0;
  for (const Detection& detection : detections.detections) {
    if (detection.width > kWidestShown) continue;
    visualization_msgs::msg::Marker m = make_marker(legs, id++, constants::CYLINDER, lifetime, header);
    m.pose(to_pose({detection.position.x(), detection.position.y(), 0.0}));
    m.pose().position().z(kLegHeight / 2.0);
    m.scale().x(std::max(detection.width, 0.05));
    m.scale().y(std::max(detection.width, 0.05));
    m.scale().z(kLegHeight);
    const auto score = static_cast<float>(detection.human_score());
    if (detection.on_static || detection.human_score() < 0.1) {
      paint(m, {0.5F, 0.5F, 0.5F, 0.3F});
    } else if (detection.leg_score >= detection.body_score) {
      paint(m, {0.2F, 0.7F, 0.3F, score});
    } else {
      paint(m, {0.2F, 0.4F, 0.9F, score});
    }
    array.markers().push_back(std::move(m));
  }
  return array;
}

}  // namespace bw::people
