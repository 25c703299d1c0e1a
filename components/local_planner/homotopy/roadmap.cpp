#include "components/local_planner/homotopy/roadmap.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "components/local_planner/homotopy/edge_check.hpp"
#include "components/model/random.hpp"

namespace bw::homotopy {
namespace {

constexpr double kShortestEdge = 1e-6;              // [m]
constexpr std::array kOffsetShares{1.0, 0.5, 0.0};  // of the way from the edge clearance to the wanted offset
constexpr double kVelocityStep = 0.1;               // [s] over which a mover's velocity is taken
constexpr double kMaxWidening = 3.0;
constexpr double kBesideEdgeClearance = 1e-3;  // [m] kept beyond it by the nearest of them

// Where a body reaches out furthest to one side of the course: how far, and from where to where along it.
struct Side {
  double reach;
  double first, last;
};

Side side_of(const Body& body, const Vector2& start, const Vector2& heading, const Vector2& outward,
             double tolerance) {
  Side side{-INFINITY, INFINITY, -INFINITY};
  const auto each_end = [&](auto&& visit) {
    for (const Part& part : body.parts) {
      for (const Vector2& end : {part.axis.a, part.axis.b}) {
        visit(heading.dot(end - start), outward.dot(end - start) + part.radius);
      }
    }
  };
  each_end([&](double, double out) { side.reach = std::max(side.reach, out); });
  each_end([&](double along, double out) {
    if (out < side.reach - tolerance) return;
    side.first = std::min(side.first, along);
    side.last = std::max(side.last, along);
  });
  return side;
}

// How much further out a robot that drives along the course must pass to keep a distance from a mover: seen
// from the mover it comes aslant, so that d beside it means only d |v_rel along the course| / |v_rel|.
double widening(const Body& body, const Course& course) {
  if (!body.motion) return 1.0;
  const double met = course.earliest_time(body.representative);
  const Vector2 velocity =
      (body.motion->position_at(met + kVelocityStep) - body.motion->position_at(met)) / kVelocityStep;
  const Vector2 relative = course.v_max * course.heading() - velocity;
  const double along = std::abs(relative.dot(course.heading()));
  return relative.norm() < kMaxWidening * along ? relative.norm() / along : kMaxWidening;
}

void add_edges(Roadmap& map, const Course& course, const EdgeCheck& check, double heading_threshold) {
  const Vector2 heading = course.heading();
  map.edges.assign(map.vertices.size(), {});
  for (std::size_t i = 0; i + 1 < map.vertices.size(); ++i) {
    for (std::size_t k = i + 1; k < map.vertices.size(); ++k) {
      const Vector2 step = map.vertices[k] - map.vertices[i];
      const double length = step.norm();
      if (length < kShortestEdge || heading.dot(step) <= heading_threshold * length) continue;
      if (check.clear(map.vertices[i], map.vertices[k])) map.edges[i].push_back({k, length});
    }
  }
}

// Start and goal around the given vertices, in the order of the path along the course, and the edges.
Roadmap joined(const Course& course, std::vector<Vector2> between, const EdgeCheck& check,
               double heading_threshold) {
  const Vector2 heading = course.heading();
  std::stable_sort(between.begin(), between.end(), [&](const Vector2& l, const Vector2& r) {
    return heading.dot(l - course.start) < heading.dot(r - course.start);
  });
  Roadmap map;
  map.vertices.push_back(course.start);
  map.vertices.insert(map.vertices.end(), between.begin(), between.end());
  map.vertices.push_back(course.goal);
  add_edges(map, course, check, heading_threshold);
  return map;
}

}  // namespace

Roadmap keypoint_roadmap(const Course& course, const std::vector<Body>& bodies,
                         const HomotopyOptions& options) {
  const Vector2 heading = course.heading();
  const EdgeCheck check(course, bodies, course.edge_clearance(options));
  const double nearest = course.robot_radius + course.edge_clearance(options) + kBesideEdgeClearance;
  const double wanted =
      std::max(nearest, course.robot_radius + course.clearance + options.kObstacleKeypointOffset);
  std::vector<Vector2> keypoints;
  for (const Body& body : bodies) {
    const double factor = widening(body, course);
    for (const Vector2& outward : {course.left(), Vector2(-course.left())}) {
      const Side side = side_of(body, course.start, heading, outward, 0.5 * nearest);
      const bool is_long = side.last - side.first > 2.0 * nearest;
      const double middle = 0.5 * (side.first + side.last);
      const std::array<double, 2> along{is_long ? side.first : middle, side.last};
      for (std::size_t k = 0; k < (is_long ? 2u : 1u); ++k) {
        if (along[k] <= 0.0 || along[k] >= course.length()) continue;
        const Vector2 beside_line{along[k], side.reach};
        if (along[k] < kVertexHeading * beside_line.norm()) continue;
        for (const double share : kOffsetShares) {
          const double beside = body.parts.front().radius + nearest + share * (wanted - nearest);
          const double out = side.reach - body.parts.front().radius + factor * beside;
          const Vector2 p = course.start + along[k] * heading + out * outward;
          if (!check.clear(p, p)) continue;
          keypoints.push_back(p);
          break;
        }
      }
    }
  }
  return joined(course, std::move(keypoints), check, kEdgeHeading);
}

Roadmap random_roadmap(const Course& course, const std::vector<Body>& bodies,
                       const HomotopyOptions& options) {
  Random random(options.roadmap_graph_seed);
  const double half_width = 0.5 * kAreaWidth;
  std::vector<Vector2> samples;
  for (int k = 0; k < kRoadmapVertices; ++k) {
    const double along = random.uniform(0.0, course.length());
    const double aside = random.uniform(-half_width, half_width);
    samples.push_back(course.start + along * course.heading() + aside * course.left());
  }
  return joined(course, std::move(samples), EdgeCheck(course, bodies, course.edge_clearance(options)),
                kEdgeHeading);
}

}  // namespace bw::homotopy
