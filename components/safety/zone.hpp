// Zones around the robot, as nav2_collision_monitor has them: what happens when the laser sees something
// inside.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "components/safety/action.hpp"
#include "components/safety/sweep.hpp"
#include "runtime/base/field.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::safety {

struct CornerOptions {
  double x = 0.0;
  double y = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("x", x, {.unit = "m", .min = -20, .max = 20, .doc = "in base_link, forward"});
    v("y", y, {.unit = "m", .min = -20, .max = 20, .doc = "in base_link, left"});
  }
};

enum class ZoneShape { circle, polygon };
constexpr auto choice_table(ZoneShape) {
  return choices<ZoneShape>({{ZoneShape::circle, "circle"}, {ZoneShape::polygon, "polygon"}});
}

/// Names and meaning of nav2's parameters. A stop zone differs in one point: motions that lead away from
/// everything inside stay allowed, so that the robot can get out: away from it, or, of a rotation, out by the
/// nearest edge of the zone.
struct ZoneOptions {
  std::string name = "zone";
  ZoneShape type = ZoneShape::circle;
  double radius = 0.35;
  std::vector<CornerOptions> points;
  Action action_type = Action::stop;
  bool enabled = true;
  std::int64_t min_points = 4;
  double slowdown_ratio = 0.5;
  double linear_limit = 0.5;
  double angular_limit = 0.5;
  double time_before_collision = 2.0;
  double simulation_time_step = 0.1;

  template <class Visitor>
  void fields(Visitor& v) {
    v("name", name, {.doc = "shown in collision_monitor_state"});
    v("type", type, {.doc = "shape of the zone"});
    v("radius", radius, {.unit = "m", .min = 0, .max = 20, .doc = "circle: radius around base_link"});
    v("points", points, {.doc = "polygon: its corners"});
    v("action_type", action_type,
      {.doc = "stop: nothing moves towards what is inside; slowdown: scale the command; limit: cap it; "
              "approach: keep time_before_collision until the shape, moved on, holds something"});
    v("enabled", enabled, {.doc = "whether the zone is looked at"});
    v("min_points", min_points,
      {.min = 1,
       .max = 10000,
       .doc = "how many returns must lie inside for the zone to act; raise it against single false ones"});
    v("slowdown_ratio", slowdown_ratio, {.min = 0, .max = 1, .doc = "slowdown: factor on the command"});
    v("linear_limit", linear_limit, {.unit = "m/s", .min = 0, .max = 10, .doc = "limit: largest speed"});
    v("angular_limit", angular_limit,
      {.unit = "rad/s", .min = 0, .max = 20, .doc = "limit: largest turn rate"});
    v("time_before_collision", time_before_collision,
      {.unit = "s", .min = 0.1, .max = 20, .doc = "approach: time before a collision that is kept"});
    v("simulation_time_step", simulation_time_step,
      {.unit = "s",
       .min = 0.01,
       .max = 1,
       .doc = "approach: step of the simulated motion; finer finds thinner things"});
  }

  std::optional<std::string> violated_rule() const {
    if (type == ZoneShape::polygon && points.size() < 3) return "points of a polygon must be at least three";
    if (type == ZoneShape::circle && !points.empty())
      return "points are for a polygon; a circle has a radius";
    return std::nullopt;
  }
};

class Zone {
 public:
  explicit Zone(const ZoneOptions& options);

  /// The share of `wanted` that the zone leaves, 0 to 1, for what the laser sees (base_link now).
  double share_left(const Twist2& wanted, const std::vector<SeenPoint>& points) const;
  const ZoneOptions& options() const { return options_; }

 private:
  bool contains(const Vector2& p) const;
  bool leads_out(const Twist2& wanted, const Vector2& p) const;
  double stop_share(const Twist2& wanted, const std::vector<SeenPoint>& points) const;
  double approach_share(const Twist2& wanted, const std::vector<SeenPoint>& points) const;
  /// min_points lie in the zone when the robot stands at X_BN.
  bool triggered(const std::vector<SeenPoint>& points, const Pose2& X_BN) const;

  ZoneOptions options_;
  std::vector<Vector2> corners_;
};

}  // namespace bw::safety
