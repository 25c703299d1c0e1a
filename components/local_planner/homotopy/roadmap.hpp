// Graphs whose paths from start to goal pass bodies on either side (theory.md 6.2, createGraph).
#pragma once

#include <vector>

#include "components/local_planner/homotopy/obstacle_bodies.hpp"

namespace bw::homotopy {

struct RoadmapEdge {
  std::size_t to = 0;
  double length = 0.0;  ///< [m]
};

/// Vertex 0 is the start, the last one the goal; edges lead to later vertices only, so there is no cycle.
struct Roadmap {
  std::vector<Vector2> vertices;
  std::vector<std::vector<RoadmapEdge>> edges;  ///< by the vertex they leave

  std::size_t goal() const { return vertices.size() - 1; }
};

/// Vertices beside each body, left and right of the course:
///
///   centre +- n (r_o + r_r + d + offset)   with n normal to the course
///
/// for a disc; for other bodies beside the part that reaches out furthest, and beside both ends of it where
/// it is long. In a gap too narrow for that, nearer; beside movers that cross, further out, since they go on
/// while the robot passes. Edges go forward (edge_heading_threshold) and keep the edge clearance from every
/// body, from movers with `motion` where they are when a robot at v_max passes; from a body that start or
/// goal is already closer to, see EdgeCheck.
Roadmap keypoint_roadmap(const Course& course, const std::vector<Body>& bodies,
                         const HomotopyOptions& options);

/// The same with random vertices in a strip around the course. Equal seeds give equal vertices relative to
/// the course.
Roadmap random_roadmap(const Course& course, const std::vector<Body>& bodies, const HomotopyOptions& options);

}  // namespace bw::homotopy
