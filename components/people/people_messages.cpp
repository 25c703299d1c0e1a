#include "components/people/people_messages.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "components/messages/geometry.hpp"

namespace bw::people {
namespace {

constexpr double kHeight = 1.7;       // of a person [m]
constexpr double kWidestShown = 1.0;  // of a detection [m]
constexpr double kLegHeight = 0.3;    // [m]

visualization_msgs::msg::Marker marker(std::int32_t id, const std::string& name_space, int type,
                                       Duration lifetime, const std_msgs::msg::Header& header) {
  visualization_msgs::msg::Marker m;
  m.header(header);
  m.ns(name_space);
  m.id(id);
  m.type(type);
  m.action(visualization_msgs::msg::Marker_Constants::ADD);
  m.lifetime(to_message(lifetime));
  return m;
}

void paint(visualization_msgs::msg::Marker& m, float r, float g, float b, double a) {
  m.color().r(r);
  m.color().g(g);
  m.color().b(b);
  m.color().a(static_cast<float>(a));
}

}  // namespace

bandwagon_msgs::msg::Tracks to_tracks(const std::vector<ReportedPerson>& people,
                                      const std_msgs::msg::Header& header) {
  bandwagon_msgs::msg::Tracks message;
  message.header(header);
  for (const ReportedPerson& person : people) {
    bandwagon_msgs::msg::Track out;
    out.id(person.body.id);
    out.position(to_point(person.body.position));
    out.velocity(to_vector3(person.body.velocity));
    out.radius(person.body.radius);
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j)
        out.covariance()[static_cast<std::size_t>(4 * i + j)] = person.covariance(i, j);
    }
    for (const PredictedPosition& predicted : person.body.predictions) {
      bandwagon_msgs::msg::PredictedPosition position;
      position.time_from_start(to_message(Duration::seconds(predicted.time)));
      position.x(predicted.position.x());
      position.y(predicted.position.y());
      position.cov_xx(predicted.covariance(0, 0));
      position.cov_xy(predicted.covariance(0, 1));
      position.cov_yy(predicted.covariance(1, 1));
      out.predictions().push_back(position);
    }
    message.tracks().push_back(std::move(out));
  }
  return message;
}

people_msgs::msg::People to_people(const std::vector<ReportedPerson>& people,
                                   const std_msgs::msg::Header& header) {
  people_msgs::msg::People message;
  message.header(header);
  for (const ReportedPerson& person : people) {
    people_msgs::msg::Person out;
    out.name(std::to_string(person.body.id));
    out.position(to_point(person.body.position));
    out.velocity().x(person.body.velocity.x());
    out.velocity().y(person.body.velocity.y());
    out.reliability(person.reliability);
    message.people().push_back(std::move(out));
  }
  return message;
}

visualization_msgs::msg::MarkerArray to_markers(const std::vector<ReportedPerson>& people, Duration lifetime,
                                                const std_msgs::msg::Header& header) {
  namespace constants = visualization_msgs::msg::Marker_Constants;
  visualization_msgs::msg::MarkerArray array;
  for (const ReportedPerson& person : people) {
    const Mover& track = person.body;
    const auto id = static_cast<std::int32_t>(track.id);
    visualization_msgs::msg::Marker body = marker(id, "people", constants::CYLINDER, lifetime, header);
    body.pose(to_pose({track.position.x(), track.position.y(), 0.0}));
    body.pose().position().z(kHeight / 2.0);
    body.scale().x(2.0 * track.radius);
    body.scale().y(2.0 * track.radius);
    body.scale().z(kHeight);
    paint(body, 0.42F, 0.35F, 0.80F, 0.7);
    array.markers().push_back(std::move(body));

    const double speed = track.velocity.norm();
    if (speed < 0.05) continue;
    visualization_msgs::msg::Marker arrow = marker(id, "velocities", constants::ARROW, lifetime, header);
    arrow.pose(to_pose(
        {track.position.x(), track.position.y(), std::atan2(track.velocity.y(), track.velocity.x())}));
    arrow.pose().position().z(kHeight / 2.0);
    arrow.scale().x(speed);  // one metre for each metre per second
    arrow.scale().y(0.08);
    arrow.scale().z(0.08);
    paint(arrow, 0.42F, 0.35F, 0.80F, 0.95);
    array.markers().push_back(std::move(arrow));
  }
  return array;
}

visualization_msgs::msg::MarkerArray to_markers(const DetectionSet& detections, Duration lifetime,
                                                const std_msgs::msg::Header& header) {
  namespace constants = visualization_msgs::msg::Marker_Constants;
  visualization_msgs::msg::MarkerArray array;
  std::int32_t id = 0;
  for (const Detection& detection : detections.detections) {
    if (detection.width > kWidestShown) continue;
    visualization_msgs::msg::Marker m = marker(id++, "legs", constants::CYLINDER, lifetime, header);
    m.pose(to_pose({detection.position.x(), detection.position.y(), 0.0}));
    m.pose().position().z(kLegHeight / 2.0);
    m.scale().x(std::max(detection.width, 0.05));
    m.scale().y(std::max(detection.width, 0.05));
    m.scale().z(kLegHeight);
    const double score = std::max(detection.leg_score, detection.body_score);
    if (detection.on_static || score < 0.1) {
      paint(m, 0.5F, 0.5F, 0.5F, 0.3);
    } else if (detection.leg_score >= detection.body_score) {
      paint(m, 0.2F, 0.7F, 0.3F, score);
    } else {
      paint(m, 0.2F, 0.4F, 0.9F, score);
    }
    array.markers().push_back(std::move(m));
  }
  return array;
}

}  // namespace bw::people
