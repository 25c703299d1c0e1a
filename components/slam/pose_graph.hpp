// Submaps and what is known of where they lie to each other; the poses that fit best, by Ceres.
#pragma once

#include <cstddef>
#include <vector>

#include "components/slam/uncertain_pose.hpp"

namespace bw::slam {

/// Pose of `to` in the frame of `from`.
struct Edge {
  std::size_t from = 0;
  std::size_t to = 0;
  UncertainPose X;
  /// Loops can be wrong: they are taken back where the rest contradicts (dynamic covariance scaling, Agarwal 2013).
  bool loop = false;
};

/// Squared Mahalanobis distance of an edge from the poses; three degrees of freedom.
double disagreement(const Edge& edge, const std::vector<Pose2>& poses);

/// Moves all poses but the first. Returns the iterations that it took.
int optimise(const std::vector<Edge>& edges, std::vector<Pose2>& poses);

/// Along the surest way through the edges, the pose of each submap in the frame of `from`, with the covariance summed
/// on the way (Dijkstra by its trace); edges with less than a tenth of their weight left are not used.
std::vector<UncertainPose> relative_to(std::size_t from, const std::vector<Edge>& edges,
                                       const std::vector<Pose2>& poses);

}  // namespace bw::slam
