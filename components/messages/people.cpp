#include "components/messages/people.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "components/messages/geometry.hpp"
#include "components/messages/markers.hpp"
#include "components/messages/prediction.hpp"
#include "components/model/mover_weight.hpp"

namespace bw::people {
namespace {

constexpr double kHeight = 1.7;  // of a person [m]
constexpr Color kBody{0.42F, 0.35F, 0.80F, 0.7F};
constexpr Color kArrow{0.42F, 0.35F, 0.80F, 0.95F};
constexpr Color kPossible{0.42F, 0.35F, 0.80F, 0.2F};  // who may be furniture

}  // namespace

bandwagon_msgs::msg::Tracks to_tracks(const std::vector<TrackedPerson>& people,
                                      const std_msgs::msg::Header& header) {
  bandwagon_msgs::msg::Tracks message;
  message.header(header);
  for (const TrackedPerson& person : people) {
    bandwagon_msgs::msg::Track out;
    out.id(person.id);
    out.position(to_point(person.position));
    out.velocity(to_vector3(person.velocity));
    out.radius(person.radius);
    out.confidence(person.confidence);
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j)
        out.covariance()[static_cast<std::size_t>(4 * i + j)] = person.covariance(i, j);
    }
    for (const PredictedPosition& predicted : person.predictions)
      out.predictions().push_back(to_message(predicted));
    message.tracks().push_back(std::move(out));
  }
  return message;
}

std::vector<TrackedPerson> from_tracks(const bandwagon_msgs::msg::Tracks& message) {
  std::vector<TrackedPerson> people;
  for (const bandwagon_msgs::msg::Track& track : message.tracks()) {
    TrackedPerson& person = people.emplace_back();
    person.id = track.id();
    person.position = {track.position().x(), track.position().y()};
    person.velocity = {track.velocity().x(), track.velocity().y()};
    person.radius = track.radius();
    person.confidence = track.confidence();
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j)
        person.covariance(i, j) = track.covariance()[static_cast<std::size_t>(4 * i + j)];
    }
    for (const bandwagon_msgs::msg::PredictedPosition& predicted : track.predictions()) {
      Eigen::Matrix2d covariance;
      covariance << predicted.cov_xx(), predicted.cov_xy(), predicted.cov_xy(), predicted.cov_yy();
      const double ahead = static_cast<double>(predicted.time_from_start().sec()) +
                           1e-9 * static_cast<double>(predicted.time_from_start().nanosec());
      person.predictions.push_back({ahead, {predicted.x(), predicted.y()}, covariance});
    }
  }
  return people;
}

people_msgs::msg::People to_people(const std::vector<TrackedPerson>& people,
                                   const std_msgs::msg::Header& header) {
  people_msgs::msg::People message;
  message.header(header);
  for (const TrackedPerson& person : people) {
    people_msgs::msg::Person out;
    out.name(std::to_string(person.id));
    out.position(to_point(person.position));
    out.velocity().x(person.velocity.x());
    out.velocity().y(person.velocity.y());
    out.reliability(person.confidence);
    message.people().push_back(std::move(out));
  }
  return message;
}

visualization_msgs::msg::MarkerArray to_markers(const std::vector<TrackedPerson>& people, Duration lifetime,
                                                const std_msgs::msg::Header& header) {
  namespace constants = visualization_msgs::msg::Marker_Constants;
  visualization_msgs::msg::MarkerArray array;
  for (const TrackedPerson& track : people) {
    const auto id = static_cast<std::int32_t>(track.id);
    visualization_msgs::msg::Marker body = make_marker("people", id, constants::CYLINDER, lifetime, header);
    body.pose(to_pose({track.position.x(), track.position.y(), 0.0}));
    body.pose().position().z(kHeight / 2.0);
    body.scale().x(2.0 * track.radius);
    body.scale().y(2.0 * track.radius);
    body.scale().z(kHeight);
    paint(body, is_confirmed(track) ? kBody : kPossible);
    array.markers().push_back(std::move(body));

    const double speed = track.velocity.norm();
    if (speed < 0.05 || !is_confirmed(track)) continue;
    visualization_msgs::msg::Marker arrow = make_marker("velocities", id, constants::ARROW, lifetime, header);
    arrow.pose(to_pose(
        {track.position.x(), track.position.y(), std::atan2(track.velocity.y(), track.velocity.x())}));
    arrow.pose().position().z(kHeight / 2.0);
    arrow.scale().x(speed);  // one metre for each metre per second
    arrow.scale().y(0.08);
    arrow.scale().z(0.08);
    paint(arrow, kArrow);
    array.markers().push_back(std::move(arrow));
  }
  return array;
}

}  // namespace bw::people
