// How often and on which side a path winds around each body: equal for two paths exactly when one can be
// pulled into the other without crossing a body (theory.md 6.2, winding vector).
#pragma once

#include <string>
#include <vector>

#include "components/local_planner/homotopy/obstacle_bodies.hpp"

namespace bw::homotopy {

/// A position of the robot and when it is there, from now.
struct RoutePoint {
  Vector2 position{0.0, 0.0};
  double time = 0.0;
};
/// Straight between its points.
using Route = std::vector<RoutePoint>;

/// `points` driven at `speed` [m/s], above zero.
Route route_at_speed(const std::vector<Vector2>& points, double speed);

/// How often the straight path crosses the cut west of the body (its negative x axis), counter-clockwise
/// positive. Summed along two routes with the same ends, it differs by the windings between them: winding
/// without trigonometry.
int cut_crossings(const Body& body, const RoutePoint& from, const RoutePoint& to);

/// Angle [rad] that the bearing from each body to the robot sweeps along the route, counter-clockwise
/// positive: negative where the robot passes left of the body, positive on its right. In effect the route is
/// joined to the start and the goal of the course, so that routes of different cycles compare. Around a body
/// with `motion` it is taken in space and time: after the route the robot waits at the goal until a time
/// common to all routes. Exactly through a body counts as right of it.
std::vector<double> winding(const Route& route, const std::vector<Body>& bodies, const Course& course);

/// round((w - v) / 2 pi) of each body: how many windings w makes more than v. Both of one course and its
/// bodies.
std::vector<int> windings_between(const std::vector<double>& w, const std::vector<double>& v);

/// No winding between them around any body.
bool same_winding(const std::vector<double>& w, const std::vector<double>& v);

/// Names for people of different classes: the side (L, R) on which each passes the bodies about which they
/// disagree, in the order in which bodies are met. A lone class is called "-".
std::vector<std::string> class_labels(const std::vector<std::vector<double>>& windings);

}  // namespace bw::homotopy
