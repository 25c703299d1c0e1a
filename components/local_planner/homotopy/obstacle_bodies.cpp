#include "components/local_planner/homotopy/obstacle_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "components/local_planner/homotopy/segment_distance.hpp"
#include "components/model/mover_weight.hpp"

namespace bw::homotopy {
namespace {

constexpr double kEquallyNear = 1e-6;  // [m]
constexpr double kMeetingGap = 0.02;   // [m] between robot and mover that counts as met
constexpr int kMeetingSteps = 200;     // most steps of that search
constexpr double kBodyStep = 0.4;      // [s] between the corners of a mover's capsule

bool touches(const Part& part, const Course& course, double half_width) {
  // The part's extent along and across the line, by its ends: cheap, and larger than the part at most.
  const auto overlaps = [&](const Vector2& axis, double low, double high) {
    const double a = axis.dot(part.axis.a - course.start);
    const double b = axis.dot(part.axis.b - course.start);
    return std::max(a, b) + part.radius >= low && std::min(a, b) - part.radius <= high;
  };
  return overlaps(course.heading(), 0.0, course.length()) && overlaps(course.left(), -half_width, half_width);
}

// What could be joined to something in the strip is kept too.
StaticObstacles within(const StaticObstacles& all, const Course& course, double half_width, double margin) {
  const auto near = [&](const Segment& axis, double radius) {
    return touches({axis, radius + margin}, course, half_width);
  };
  StaticObstacles kept;
  for (const Vector2& p : all.points) {
    if (near({p, p}, 0.0)) kept.points.push_back(p);
  }
  for (const Disc& d : all.discs) {
    if (near({d.center, d.center}, d.radius)) kept.discs.push_back(d);
  }
  for (const Segment& s : all.segments) {
    if (near(s, 0.0)) kept.segments.push_back(s);
  }
  return kept;
}

// The middle of the part nearest to the mean: on the body, and far from its edge where it has an inside. Of
// equally near ones the first on the course, so that the choice does not depend on the frame.
Vector2 middle_of(const std::vector<Part>& parts, const Course& course) {
  const auto middle = [](const Part& part) { return Vector2(0.5 * (part.axis.a + part.axis.b)); };
  Vector2 mean{0.0, 0.0};
  for (const Part& part : parts) mean += middle(part) / static_cast<double>(parts.size());
  double nearest = std::numeric_limits<double>::infinity();
  for (const Part& part : parts) nearest = std::min(nearest, (middle(part) - mean).norm());
  std::optional<Vector2> best;
  for (const Part& part : parts) {
    const Vector2 candidate = middle(part);
    if ((candidate - mean).norm() > nearest + kEquallyNear) continue;
    if (!best || course.heading().dot(candidate - *best) < 0.0) best = candidate;
  }
  return *best;
}

// When a robot that heads for the mover at v_max meets it, if that is before it could be at the goal. Steps
// by the time in which the gap cannot close.
std::optional<double> meeting_time(const Mover& mover, const Course& course) {
  const double last = course.earliest_time(course.goal);
  const double closing_speed = course.v_max + mover.top_speed();
  double time = 0.0;
  for (int step = 0; step < kMeetingSteps && time <= last; ++step) {
    const double gap = (mover.position_at(time) - course.start).norm() - course.v_max * time;
    if (gap <= kMeetingGap) return time;
    time += gap / closing_speed;
  }
  return std::nullopt;
}

std::optional<Body> body_of(const Mover& mover, const Course& course, const HomotopyOptions& options) {
  Body body;
  body.mover_id = mover.id;
  const auto disc_at = [&](const Vector2& p) { return Part{{p, p}, mover.radius}; };
  if (options.mover_topology == MoverTopology::time_indexed) {
    const std::optional<double> time = meeting_time(mover, course);
    if (!time) return std::nullopt;
    body.parts = {disc_at(mover.position_at(*time))};
    body.motion = mover;
  } else if (options.mover_topology == MoverTopology::capsule && options.prediction_horizon > 0.0) {
    const int steps =
        mover.predictions.empty() ? 1 : static_cast<int>(std::ceil(options.prediction_horizon / kBodyStep));
    for (int k = 0; k < steps; ++k) {
      const double step = options.prediction_horizon / steps;
      const Segment path{mover.position_at(k * step), mover.position_at((k + 1) * step)};
      body.parts.push_back({path, mover.radius});
    }
  } else {
    body.parts = {disc_at(mover.position)};
  }
  body.representative = middle_of(body.parts, course);
  return body;
}

double distance_to_line(const Body& body, const Course& course) {
  double distance = std::numeric_limits<double>::infinity();
  for (const Part& part : body.parts) {
    const double to_axis = std::sqrt(squared_distance(Segment{course.start, course.goal}, part.axis));
    distance = std::min(distance, to_axis - part.radius);
  }
  return distance;
}

void keep_nearest(std::vector<Body>& bodies, const Course& course, std::size_t count) {
  if (bodies.size() <= count) return;
  std::vector<std::tuple<bool, double, std::size_t>> order;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    order.emplace_back(!bodies[i].mover_id, distance_to_line(bodies[i], course), i);
  }
  std::sort(order.begin(), order.end());
  std::vector<Body> kept;
  for (std::size_t i = 0; i < count; ++i) kept.push_back(std::move(bodies[std::get<2>(order[i])]));
  bodies = std::move(kept);
}

}  // namespace

std::vector<Body> bodies_of(const StaticObstacles& obstacles, const std::vector<Mover>& movers,
                            const Course& course, const HomotopyOptions& options) {
  std::vector<Body> bodies;
  if (course.length() <= 0.0) return bodies;
  const double half_width = 0.5 * kAreaWidth;
  const double widest_gap = 2.0 * (course.robot_radius + course.edge_clearance(options));
  const auto matters = [&](const std::vector<Part>& parts) {
    return std::any_of(parts.begin(), parts.end(),
                       [&](const Part& part) { return touches(part, course, half_width); });
  };
  for (std::vector<Part>& parts :
       clusters_of(within(obstacles, course, half_width, widest_gap), widest_gap)) {
    if (!matters(parts)) continue;
    const Vector2 middle = middle_of(parts, course);
    bodies.push_back({std::move(parts), middle, std::nullopt, std::nullopt});
  }
  for (const Mover& mover : movers) {
    if (!is_confirmed(mover)) continue;
    std::optional<Body> body = body_of(mover, course, options);
    if (body && matters(body->parts)) bodies.push_back(std::move(*body));
  }
  const auto order_of = [&](const Body& body) {
    const Vector2 from_start = body.representative - course.start;
    return std::make_tuple(course.heading().dot(from_start), course.left().dot(from_start),
                           body.mover_id.has_value(), body.mover_id.value_or(0), body.parts.front().radius);
  };
  const auto met_before = [&](const Body& l, const Body& r) { return order_of(l) < order_of(r); };
  std::sort(bodies.begin(), bodies.end(), met_before);
  keep_nearest(bodies, course, static_cast<std::size_t>(options.max_bodies));
  std::sort(bodies.begin(), bodies.end(), met_before);
  return bodies;
}

}  // namespace bw::homotopy
