#include "components/world/scripted_people.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace bw {
namespace {

Vector2 position_of(const WaypointOptions& waypoint) { return {waypoint.x, waypoint.y}; }

double path_length(const std::vector<WaypointOptions>& waypoints) {
  double length = 0.0;
  for (std::size_t i = 1; i < waypoints.size(); ++i)
    length += (position_of(waypoints[i]) - position_of(waypoints[i - 1])).norm();
  return length;
}

/// Position and direction of travel after `distance` [m] along the waypoints.
void walk(const std::vector<WaypointOptions>& waypoints, double distance, Vector2& position,
          Vector2& heading) {
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    const Vector2 leg = position_of(waypoints[i]) - position_of(waypoints[i - 1]);
    const double length = leg.norm();
    if (length > 0.0) heading = leg / length;
    if (distance <= length) {
      position = position_of(waypoints[i - 1]) + heading * distance;
      return;
    }
    distance -= length;
  }
  position = position_of(waypoints.back());
}

Person locate(const ScriptedPersonOptions& script, std::uint32_t id, double time) {
  Person person{id, position_of(script.waypoints.front()), {0.0, 0.0}, script.radius};
  const double length = path_length(script.waypoints);
  const double walked = script.speed * (time - script.start_time);
  if (walked < 0.0 || length == 0.0 || (walked >= length && !script.turn_round)) {
    if (walked > 0.0) person.position = position_of(script.waypoints.back());
    return person;
  }
  const double phase = std::fmod(walked, 2.0 * length);
  const bool forth = phase < length;
  Vector2 heading{0.0, 0.0};
  walk(script.waypoints, forth ? phase : 2.0 * length - phase, person.position, heading);
  person.velocity = heading * (forth ? script.speed : -script.speed);
  return person;
}

}  // namespace

ScriptedPeople::ScriptedPeople(std::vector<ScriptedPersonOptions> people, std::uint32_t first_id)
    : people_(std::move(people)), first_id_(first_id) {
  for (const ScriptedPersonOptions& script : people_) {
    if (const auto rule = script.violated_rule()) throw std::runtime_error("scripted person: " + *rule);
  }
}

void ScriptedPeople::step(double dt, const Surroundings&, std::vector<Person>& people) {
  time_ += dt;
  std::uint32_t id = first_id_;
  for (const ScriptedPersonOptions& script : people_) {
    people.push_back(locate(script, id++, time_));
    if (const auto aside = aside_.find(people.back().id); aside != aside_.end())
      people.back().position += aside->second;
  }
}

bool ScriptedPeople::displace(std::uint32_t id, const Vector2& by) {
  if (id < first_id_ || id - first_id_ >= people_.size()) return false;
  aside_.try_emplace(id, 0.0, 0.0).first->second += by;
  return true;
}

}  // namespace bw
