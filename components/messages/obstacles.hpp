// Obstacles as a message and back. For adaptors only.
#pragma once

#include <string>
#include <vector>

#include <bandwagon_msgs/msg/obstacles.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>

#include "components/messages/geometry.hpp"
#include "components/model/mover_weight.hpp"
#include "components/model/obstacles.hpp"

namespace bw {

/// X_FO: frame of the obstacles in `frame`.
inline bandwagon_msgs::msg::Obstacles to_message(const StaticObstacles& obstacles, const Pose2& X_FO,
                                                 const std::string& frame, Time stamp) {
  bandwagon_msgs::msg::Obstacles message;
  message.header(make_header(frame, stamp));
  for (const Vector2& p : obstacles.points) {
    const Vector2 q = X_FO * p;
    geometry_msgs::msg::Point32 point;
    point.x(static_cast<float>(q.x()));
    point.y(static_cast<float>(q.y()));
    message.points().push_back(point);
  }
  for (const Disc& d : obstacles.discs) {
    const Vector2 center = X_FO * d.center;
    bandwagon_msgs::msg::Disc disc;
    disc.x(static_cast<float>(center.x()));
    disc.y(static_cast<float>(center.y()));
    disc.radius(static_cast<float>(d.radius));
    message.discs().push_back(disc);
  }
  for (const Segment& s : obstacles.segments) {
    const Vector2 a = X_FO * s.a;
    const Vector2 b = X_FO * s.b;
    bandwagon_msgs::msg::LineSegment line;
    line.x1(static_cast<float>(a.x()));
    line.y1(static_cast<float>(a.y()));
    line.x2(static_cast<float>(b.x()));
    line.y2(static_cast<float>(b.y()));
    message.segments().push_back(line);
  }
  return message;
}

/// X_OF: pose of the message's frame in the frame wanted. What is not finite is kept.
inline StaticObstacles to_obstacles(const bandwagon_msgs::msg::Obstacles& message, const Pose2& X_OF) {
  StaticObstacles obstacles;
  for (const auto& p : message.points()) obstacles.points.push_back(X_OF * Vector2(p.x(), p.y()));
  for (const auto& d : message.discs()) {
    obstacles.discs.push_back(
        {.center = X_OF * Vector2(d.x(), d.y()), .radius = static_cast<double>(d.radius())});
  }
  for (const auto& s : message.segments()) {
    obstacles.segments.push_back({.a = X_OF * Vector2(s.x1(), s.y1()), .b = X_OF * Vector2(s.x2(), s.y2())});
  }
  return obstacles;
}

/// Confirmed people `age` [s] after the message, in the frame that X_TF is seen from; without those that are
/// not finite or larger than a person. A possible person stays an obstacle (local_planner/theory.md 7.10).
inline std::vector<Disc> to_discs(const bandwagon_msgs::msg::Tracks& message, double age, const Pose2& X_TF) {
  constexpr double kMaxRadius = 1.0;  // [m]
  std::vector<Disc> discs;
  for (const auto& track : message.tracks()) {
    if (!is_confirmed(track.confidence())) continue;
    const Vector2 position(track.position().x() + age * track.velocity().x(),
                           track.position().y() + age * track.velocity().y());
    if (position.allFinite() && track.radius() >= 0.0 && track.radius() <= kMaxRadius)
      discs.push_back({X_TF * position, track.radius()});
  }
  return discs;
}

}  // namespace bw
