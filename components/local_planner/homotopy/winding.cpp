#include "components/local_planner/homotopy/winding.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bw::homotopy {
namespace {

constexpr double kPredictionStep = 0.4;  // [s] within which a predicted motion is taken as straight
constexpr double kMaxSteps = 256;        // of one leg of a route
constexpr double kSettlingFactor = 2.0;  // of the drive to the goal, after which all routes wait there ...
constexpr double kSettlingTime = 5.0;    // ... and [s] on top

// Bearing in (-pi, pi]; the sum turns a negative zero into a positive one.
double bearing(const Vector2& v) { return std::atan2(v.y() + 0.0, v.x()); }

// How the straight path u-v crosses the negative x axis, where bearings jump: 1 counter-clockwise, -1
// clockwise. Through the origin counts as half a turn counter-clockwise.
int cut_crossing(const Vector2& u, const Vector2& v) {
  const double orientation = cross(u, v);
  if (orientation == 0.0 && u.dot(v) < 0.0) return u.y() > 0.0 || (u.y() == 0.0 && u.x() < 0.0) ? 1 : 0;
  const bool from_above = u.y() >= 0.0;
  const bool to_above = v.y() >= 0.0;
  if (from_above == to_above) return 0;
  if (from_above) return orientation > 0.0 ? 1 : 0;
  return orientation < 0.0 ? -1 : 0;
}

Vector2 seen_from(const Body& body, const RoutePoint& p) { return p.position - body.position_at(p.time); }

}  // namespace

int cut_crossings(const Body& body, const RoutePoint& from, const RoutePoint& to) {
  const Vector2 first = seen_from(body, from);
  const Vector2 end = seen_from(body, to);
  if (!body.motion || body.motion->predictions.empty()) return cut_crossing(first, end);
  const double legs = std::ceil(std::abs(to.time - from.time) / kPredictionStep);
  const int steps = static_cast<int>(std::clamp(legs, 1.0, kMaxSteps));
  int crossings = 0;
  Vector2 last = first;
  for (int k = 1; k <= steps; ++k) {
    const double s = static_cast<double>(k) / steps;
    const Vector2 next = k == steps ? end
                                    : seen_from(body, {from.position + s * (to.position - from.position),
                                                       from.time + s * (to.time - from.time)});
    crossings += cut_crossing(last, next);
    last = next;
  }
  return crossings;
}

Route route_at_speed(const std::vector<Vector2>& points, double speed) {
  Route route;
  route.reserve(points.size());
  for (const Vector2& p : points) {
    const double time = route.empty() ? 0.0 : route.back().time + (p - route.back().position).norm() / speed;
    route.push_back({p, time});
  }
  return route;
}

std::vector<double> winding(const Route& route, const std::vector<Body>& bodies, const Course& course) {
  const double arrival = route.empty() ? course.earliest_time(course.goal) : route.back().time;
  const double settled = kSettlingFactor * course.earliest_time(course.goal) + kSettlingTime;
  std::vector<double> angles;
  angles.reserve(bodies.size());
  const RoutePoint start{course.start, route.empty() ? 0.0 : route.front().time};
  for (const Body& body : bodies) {
    int crossings = 0;
    RoutePoint last = start;
    const auto go_to = [&](const RoutePoint& next) {
      crossings += cut_crossings(body, last, next);
      last = next;
    };
    for (const RoutePoint& p : route) go_to(p);
    go_to({course.goal, arrival});
    if (body.motion && settled > arrival) go_to({course.goal, settled});
    angles.push_back(bearing(seen_from(body, last)) - bearing(seen_from(body, start)) +
                     2.0 * std::numbers::pi * crossings);
  }
  return angles;
}

std::vector<int> windings_between(const std::vector<double>& w, const std::vector<double>& v) {
  std::vector<int> differences;
  for (std::size_t i = 0; i < std::min(w.size(), v.size()); ++i) {
    differences.push_back(static_cast<int>(std::lround((w[i] - v[i]) / (2.0 * std::numbers::pi))));
  }
  return differences;
}

bool same_winding(const std::vector<double>& w, const std::vector<double>& v) {
  const std::vector<int> differences = windings_between(w, v);
  return std::all_of(differences.begin(), differences.end(), [](int t) { return t == 0; });
}

std::vector<std::string> class_labels(const std::vector<std::vector<double>>& windings) {
  std::vector<std::string> labels(windings.size());
  if (windings.empty()) return labels;
  for (std::size_t body = 0; body < windings.front().size(); ++body) {
    const bool disputed = std::any_of(windings.begin(), windings.end(), [&](const std::vector<double>& w) {
      return std::lround((w[body] - windings.front()[body]) / (2.0 * std::numbers::pi)) != 0;
    });
    if (!disputed) continue;
    for (std::size_t k = 0; k < windings.size(); ++k) labels[k] += windings[k][body] < 0.0 ? 'L' : 'R';
  }
  for (std::string& label : labels) {
    if (label.empty()) label = "-";
  }
  return labels;
}

}  // namespace bw::homotopy
