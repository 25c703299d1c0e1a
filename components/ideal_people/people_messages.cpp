#include "components/ideal_people/people_messages.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "components/messages/geometry.hpp"

namespace bw {
namespace {

constexpr double kHeight = 1.7;  // of a person [m]

visualization_msgs::msg::Marker marker(const Mover& track, const std::string& name_space, int type,
                                       Duration lifetime, const std_msgs::msg::Header& header) {
  visualization_msgs::msg::Marker m;
  m.header(header);
  m.ns(name_space);
  m.id(static_cast<std::int32_t>(track.id));
  m.type(type);
  m.action(visualization_msgs::msg::Marker_Constants::ADD);
  m.lifetime(to_message(lifetime));
  m.color().r(0.42F);
  m.color().g(0.35F);
  m.color().b(0.80F);
  return m;
}

}  // namespace

std::vector<Mover> people_of(const bandwagon_msgs::msg::GroundTruth& truth) {
  std::vector<Mover> people;
  people.reserve(truth.people().size());
  for (const auto& person : truth.people()) {
    people.push_back({.id = person.id(),
                      .position = {person.position().x(), person.position().y()},
                      .velocity = {person.velocity().x(), person.velocity().y()},
                      .radius = person.radius()});
  }
  return people;
}

bandwagon_msgs::msg::Tracks to_tracks(const std::vector<Mover>& tracks, const IdealPeopleOptions& options,
                                      const std_msgs::msg::Header& header) {
  bandwagon_msgs::msg::Tracks message;
  message.header(header);
  for (const Mover& track : tracks) {
    bandwagon_msgs::msg::Track out;
    out.id(track.id);
    out.position(to_point(track.position));
    out.velocity(to_vector3(track.velocity));
    out.radius(track.radius);
    out.covariance()[0] = out.covariance()[5] = options.position_noise * options.position_noise;
    out.covariance()[10] = out.covariance()[15] = options.velocity_noise * options.velocity_noise;
    for (const PredictedPosition& predicted : track.predictions) {
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

people_msgs::msg::People to_people(const std::vector<Mover>& tracks, const std_msgs::msg::Header& header) {
  people_msgs::msg::People message;
  message.header(header);
  for (const Mover& track : tracks) {
    people_msgs::msg::Person person;
    person.name(std::to_string(track.id));
    person.position(to_point(track.position));
    person.velocity().x(track.velocity.x());
    person.velocity().y(track.velocity.y());
    person.reliability(1.0);
    message.people().push_back(std::move(person));
  }
  return message;
}

visualization_msgs::msg::MarkerArray to_markers(const std::vector<Mover>& tracks, double rate,
                                                const std_msgs::msg::Header& header) {
  namespace constants = visualization_msgs::msg::Marker_Constants;
  const Duration lifetime = Duration::seconds(2.5 / rate);
  visualization_msgs::msg::MarkerArray array;
  for (const Mover& track : tracks) {
    visualization_msgs::msg::Marker body = marker(track, "people", constants::CYLINDER, lifetime, header);
    body.pose(to_pose({track.position.x(), track.position.y(), 0.0}));
    body.pose().position().z(kHeight / 2.0);
    body.scale().x(2.0 * track.radius);
    body.scale().y(2.0 * track.radius);
    body.scale().z(kHeight);
    body.color().a(0.7F);
    array.markers().push_back(std::move(body));

    const double speed = track.velocity.norm();
    if (speed < 0.05) continue;
    visualization_msgs::msg::Marker arrow = marker(track, "velocities", constants::ARROW, lifetime, header);
    arrow.pose(to_pose(
        {track.position.x(), track.position.y(), std::atan2(track.velocity.y(), track.velocity.x())}));
    arrow.pose().position().z(kHeight / 2.0);
    arrow.scale().x(speed);  // one metre for each metre per second
    arrow.scale().y(0.08);
    arrow.scale().z(0.08);
    arrow.color().a(0.95F);
    array.markers().push_back(std::move(arrow));
  }
  return array;
}

}  // namespace bw
