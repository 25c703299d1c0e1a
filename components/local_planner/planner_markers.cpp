#include "components/local_planner/planner_markers.hpp"

#include "components/messages/geometry.hpp"

namespace bw {
namespace {

// Values of visualization_msgs/msg/Marker.
constexpr std::int32_t kLineStrip = 4;
constexpr std::int32_t kSphereList = 7;
constexpr std::int32_t kDeleteAll = 3;

visualization_msgs::msg::Marker make_marker(const std_msgs::msg::Header& header, const std::string& ns,
                                            int id, std::int32_t type, double size,
                                            std::array<float, 4> rgba) {
  visualization_msgs::msg::Marker marker;
  marker.header(header);
  marker.ns(ns);
  marker.id(id);
  marker.type(type);
  marker.pose(to_pose({}));
  marker.scale().x(size);
  marker.scale().y(size);
  marker.scale().z(size);
  marker.color().r(rgba[0]);
  marker.color().g(rgba[1]);
  marker.color().b(rgba[2]);
  marker.color().a(rgba[3]);
  return marker;
}

}  // namespace

visualization_msgs::msg::MarkerArray to_markers(const PlanningProblem& problem, const PlanningResult& result,
                                                const std::string& frame) {
  const std_msgs::msg::Header header = make_header(frame, problem.now);
  visualization_msgs::msg::MarkerArray array;
  visualization_msgs::msg::Marker clear;
  clear.header(header);
  clear.action(kDeleteAll);
  array.markers().push_back(clear);
  int id = 0;
  for (const Candidate& candidate : result.candidates) {
    const std::array<float, 4> color =
        candidate.chosen ? std::array{0.1F, 0.7F, 0.2F, 1.0F} : std::array{0.5F, 0.5F, 0.5F, 0.6F};
    auto line = make_marker(header, "candidates", id++, kLineStrip, candidate.chosen ? 0.05 : 0.025, color);
    for (const TrajectoryPoint& point : candidate.trajectory)
      line.points().push_back(to_point(point.pose.position()));
    if (line.points().size() >= 2) array.markers().push_back(std::move(line));
  }
  for (const Mover& mover : problem.movers) {
    auto dots = make_marker(header, "predictions", static_cast<int>(mover.id), kSphereList, 0.1,
                            {0.9F, 0.4F, 0.1F, 0.7F});
    for (int step = 1; step <= 6; ++step) dots.points().push_back(to_point(mover.position_at(0.5 * step)));
    array.markers().push_back(std::move(dots));
  }
  return array;
}

}  // namespace bw
