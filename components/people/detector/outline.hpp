// The visible outline of one cluster, seen from the scanner: origin at the mean of its points, x along the
// line of sight away from the scanner, y to the left.
#pragma once

#include <vector>

#include "components/people/detector/clusters.hpp"

namespace bw::people {

struct Outline {
  Pose2 X_OC;             ///< this frame C in O
  double distance = 0.0;  ///< from the scanner, which lies at (-distance, 0) [m]
  double spacing = 0.0;   ///< between beams at that distance [m]
  double angle_increment = 0.0;
  ClusterEdge right;
  ClusterEdge left;
  Vector2 right_ray{1.0, 0.0};  ///< unit vector half a beam right of the first point, in C
  Vector2 left_ray{1.0, 0.0};   ///< half a beam left of the last point
  std::vector<Vector2> points;  ///< from right to left

  Vector2 scanner() const { return {-distance, 0.0}; }
  double width() const { return (points.back() - points.front()).norm(); }
};

/// Fills `outline`, keeping its memory.
void read_outline(const Beams& beams, const Clusters& clusters, const Cluster& cluster, Outline& outline);

}  // namespace bw::people
