#include "components/local_planner/homotopy/edge_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "components/local_planner/homotopy/segment_distance.hpp"

namespace bw::homotopy {
namespace {

constexpr double kPredictionStep = 0.4;  // [s] within which a predicted motion is taken as straight
constexpr int kMostSteps = 64;           // of one edge
constexpr double kRounding = 1e-9;       // [m]

}  // namespace

EdgeCheck::EdgeCheck(const Course& course, const std::vector<Body>& bodies, double clearance)
    : course_(course), clearance_(clearance) {
  watched_.reserve(bodies.size());
  for (const Body& body : bodies) {
    Watched w{&body, {body.representative, body.representative}, 0.0, 0.0};
    for (const Part& part : body.parts) {
      const Vector2 reach{part.radius, part.radius};
      w.box.low = w.box.low.cwiseMin(part.axis.a - reach).cwiseMin(part.axis.b - reach);
      w.box.high = w.box.high.cwiseMax(part.axis.a + reach).cwiseMax(part.axis.b + reach);
    }
    w.at_start = gap(body, course.start, course.start, -std::numeric_limits<double>::infinity());
    w.at_goal = gap(body, course.goal, course.goal, -std::numeric_limits<double>::infinity());
    watched_.push_back(w);
  }
}

// Smallest gap along the edge; the search ends once it is below `enough`.
double EdgeCheck::gap(const Body& body, const Vector2& from, const Vector2& to, double enough) const {
  double smallest = std::numeric_limits<double>::infinity();
  if (!body.motion) {
    for (const Part& part : body.parts) {
      const double distance = std::sqrt(squared_distance(Segment{from, to}, part.axis));
      smallest = std::min(smallest, distance - part.radius - course_.robot_radius);
      if (smallest < enough) break;
    }
    return smallest;
  }
  // Seen from the mover the robot drives from point to point too: straight while the mover does not turn.
  const double start_time = course_.earliest_time(from);
  const double duration = course_.earliest_time(to) - start_time;
  const double legs =
      body.motion->predictions.empty() ? 1.0 : std::ceil(std::abs(duration) / kPredictionStep);
  const int steps = static_cast<int>(std::clamp(legs, 1.0, static_cast<double>(kMostSteps)));
  Vector2 last = from - body.position_at(start_time);
  for (int k = 1; k <= steps; ++k) {
    const double s = static_cast<double>(k) / steps;
    const Vector2 next = from + s * (to - from) - body.position_at(start_time + s * duration);
    const double distance = std::sqrt(squared_distance(Vector2(0.0, 0.0), Segment{last, next}));
    smallest = std::min(smallest, distance - body.motion->radius - course_.robot_radius);
    if (smallest < enough) break;
    last = next;
  }
  return smallest;
}

bool EdgeCheck::clear(const Vector2& from, const Vector2& to) const {
  const double reach = course_.robot_radius + clearance_;
  const Vector2 low = from.cwiseMin(to) - Vector2(reach, reach);
  const Vector2 high = from.cwiseMax(to) + Vector2(reach, reach);
  const bool leaves_start = from == course_.start;
  const bool enters_goal = to == course_.goal;
  for (const Watched& w : watched_) {
    if (!w.body->motion &&
        ((low.array() > w.box.high.array()).any() || (high.array() < w.box.low.array()).any()))
      continue;
    double needed = clearance_;
    const auto allow_from = [&](double gap_there) {
      if (gap_there < clearance_) needed = std::min(needed, gap_there - 0.5 * course_.robot_radius);
    };
    if (leaves_start) allow_from(w.at_start);
    if (enters_goal) allow_from(w.at_goal);
    needed -= kRounding;
    if (gap(*w.body, from, to, needed) < needed) return false;
  }
  return true;
}

}  // namespace bw::homotopy
