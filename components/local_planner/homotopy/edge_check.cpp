#include "components/local_planner/homotopy/edge_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "components/local_planner/homotopy/segment_distance.hpp"

namespace bw::homotopy {
namespace {

constexpr double kPredictionStep = 0.4;  // [s] within which a predicted motion is taken as straight
constexpr int kMaxSteps = 64;            // of one edge
constexpr double kAreaRounding = 1e-9;   // [m]
constexpr std::size_t kManyParts = 32;   // of a body, from which on those near an edge are looked for
constexpr double kPiece = 0.5;           // [m] of an edge for which they are
constexpr double kMaxPieces = 1000.0;    // of an edge; those of a longer one are longer

// The part of the edge that lies within `aside` of the box along each axis; nothing where it has none.
std::optional<Segment> within(const Segment& edge, const Vector2& low, const Vector2& high, double aside) {
  const Vector2 whole = edge.b - edge.a;
  double first = 0.0, last = 1.0;
  for (Eigen::Index i = 0; i < 2; ++i) {
    const double from = low[i] - aside - edge.a[i], to = high[i] + aside - edge.a[i];
    if (whole[i] == 0.0) {
      if (from > 0.0 || to < 0.0) return std::nullopt;
      continue;
    }
    const auto [enters, leaves] = std::minmax({from / whole[i], to / whole[i]});
    first = std::max(first, enters);
    last = std::min(last, leaves);
  }
  if (first > last) return std::nullopt;
  return Segment{edge.a + first * whole, edge.a + last * whole};
}

}  // namespace

EdgeCheck::EdgeCheck(const Course& course, const std::vector<Body>& bodies, double clearance)
    : course_(course), clearance_(clearance) {
  watched_.reserve(bodies.size());
  for (const Body& body : bodies) {
    Watched w{&body, {body.representative, body.representative}, 0.0, 0.0, {}};
    if (!body.motion && body.parts.size() > kManyParts) w.parts = CapsuleIndex(capsules_of(body.parts));
    for (const Part& part : body.parts) {
      const Vector2 reach{part.radius, part.radius};
      w.box.low = w.box.low.cwiseMin(part.axis.a - reach).cwiseMin(part.axis.b - reach);
      w.box.high = w.box.high.cwiseMax(part.axis.a + reach).cwiseMax(part.axis.b + reach);
    }
    w.at_start = gap(w, course.start, course.start, clearance);
    w.at_goal = gap(w, course.goal, course.goal, clearance);
    watched_.push_back(std::move(w));
  }
}

// Smallest gap along the edge, if it is below `wanted`.
double EdgeCheck::gap(const Watched& watched, const Vector2& from, const Vector2& to, double wanted) const {
  const Body& body = *watched.body;
  double smallest = std::numeric_limits<double>::infinity();
  if (!body.motion) {
    if (watched.parts.size() > 0) return gap_to_many(watched, {from, to}, wanted);
    for (const Part& part : body.parts) {
      const double distance = std::sqrt(squared_distance(Segment{from, to}, part.axis));
      smallest = std::min(smallest, distance - part.radius - course_.robot_radius);
    }
    return smallest;
  }
  // Seen from the mover the robot drives from point to point too: straight while the mover does not turn.
  const double start_time = course_.earliest_time(from);
  const double duration = course_.earliest_time(to) - start_time;
  const double legs =
      body.motion->predictions.empty() ? 1.0 : std::ceil(std::abs(duration) / kPredictionStep);
  const int steps = static_cast<int>(std::clamp(legs, 1.0, static_cast<double>(kMaxSteps)));
  Vector2 last = from - body.position_at(start_time);
  for (int k = 1; k <= steps; ++k) {
    const double s = static_cast<double>(k) / steps;
    const Vector2 next = from + s * (to - from) - body.position_at(start_time + s * duration);
    const double distance = std::sqrt(squared_distance(Vector2(0.0, 0.0), Segment{last, next}));
    smallest = std::min(smallest, distance - body.motion->radius - course_.robot_radius);
    last = next;
  }
  return smallest;
}

// The edge in short pieces: around a long one there would be much that is not near it.
double EdgeCheck::gap_to_many(const Watched& watched, const Segment& edge, double wanted) const {
  const CapsuleIndex& parts = watched.parts;
  double smallest = std::numeric_limits<double>::infinity();
  const double aside = std::max(0.0, course_.robot_radius + wanted) + kAreaRounding;
  const std::optional<Segment> near = within(edge, watched.box.low, watched.box.high, aside);
  if (!near) return smallest;
  const Vector2 whole = near->b - near->a;
  const int pieces = static_cast<int>(std::clamp(std::ceil(whole.norm() / kPiece), 1.0, kMaxPieces));
  const double reach = 0.5 * whole.norm() / pieces + aside;
  for (int i = 0; i < pieces; ++i) {
    parts.visit_near(near->a + whole * ((i + 0.5) / pieces), reach, [&](const CapsuleIndex::Group& group) {
      for (const std::uint32_t k : parts.members(group)) {
        const Capsule& part = parts.capsules()[k];
        const double distance = std::sqrt(squared_distance(edge, Segment{part.a, part.b}));
        smallest = std::min(smallest, distance - part.radius - course_.robot_radius);
      }
    });
    if (smallest < wanted) break;
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
    needed -= kAreaRounding;
    if (gap(w, from, to, needed) < needed) return false;
  }
  return true;
}

}  // namespace bw::homotopy
