// People who follow waypoints at constant speed, whatever happens around them. One waypoint: somebody who
// stands.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "components/world/person.hpp"
#include "runtime/base/field.hpp"

namespace bw {

struct WaypointOptions {
  double x = 0.0;
  double y = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("x", x, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "in map"});
    v("y", y, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "in map"});
  }
};

struct ScriptedPersonOptions {
  std::vector<WaypointOptions> waypoints;
  double speed = 1.0;
  double start_time = 0.0;
  bool turn_round = false;
  /// [m] radius of the disc that counts as contact (set by code alone)
  double radius = 0.3;

  template <class Visitor>
  void fields(Visitor& v) {
    v("waypoints", waypoints, {.doc = "places in order; a single one: the person stands"});
    v("speed", speed, {.unit = "m/s", .min = 0, .max = 10, .doc = "walking speed"});
    v("start_time", start_time,
      {.unit = "s", .min = 0, .max = 1e6, .doc = "stands at the first waypoint until then"});
    v("turn_round", turn_round, {.doc = "walks back at the end, to and fro; else stands there"});
    v.retired({"radius"}, "a constant of scripted_people.hpp");
  }

  std::optional<std::string> violated_rule() const {
    if (waypoints.empty()) return "waypoints must name at least one place";
    return std::nullopt;
  }
};

/// A closed form of time: where one scripted person is `time` [s] after the start.
class ScriptedPeople final : public PeopleModel {
 public:
  /// Ids count up from `first_id`. Throws std::runtime_error when somebody breaks their rule.
  ScriptedPeople(std::vector<ScriptedPersonOptions> people, std::uint32_t first_id);
  void step(double dt, const Surroundings& surroundings, std::vector<Person>& people) override;
  /// They walk on beside their line.
  bool displace(std::uint32_t id, const Vector2& by) override;

 private:
  std::vector<ScriptedPersonOptions> people_;
  std::map<std::uint32_t, Vector2> aside_;  ///< of their line, by id, of those who were displaced
  std::uint32_t first_id_;
  double time_ = 0.0;
};

}  // namespace bw
