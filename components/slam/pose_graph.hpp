// Submaps and what is known of where they lie to each other; the poses that fit best, by Ceres.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "components/slam/uncertain_pose.hpp"

namespace bw::slam {

/// Pose of `to` in the frame of `from`.
struct Edge {
  std::size_t from = 0;
  std::size_t to = 0;
  UncertainPose X;
  /// Loops can be wrong: they are taken back where the rest contradicts (dynamic covariance scaling, Agarwal
  /// 2013).
  bool loop = false;
};

/// Squared Mahalanobis distance of an edge from the poses; three degrees of freedom.
double disagreement(const Edge& edge, const std::vector<Pose2>& poses);

/// Share of its weight that is left to a loop, 1 to 0, by how far it is off (theory.md 10.10).
double weight_left(const Edge& loop, const std::vector<Pose2>& poses);

/// Finds the poses that fit best, in short steps: a graph of 700 submaps takes some
/// milliseconds each. Graduated: what is far off at first is let pull before it is judged (graduated
/// non-convexity, Yang 2020; theory.md 10.10), unless it is a loop that the drive does not allow.
class Optimisation {
 public:
  /// The first pose that has an edge stays where it is, and those that have none.
  Optimisation(std::vector<Edge> edges, std::vector<Pose2> poses);
  ~Optimisation();
  Optimisation(const Optimisation&) = delete;
  Optimisation& operator=(const Optimisation&) = delete;

  /// The first one takes longer: it looks at all loops. False when it is finished.
  bool step();
  std::vector<Pose2> poses() const;

 private:
  struct Problem;
  std::vector<Edge> edges_;
  std::vector<Pose2> poses_;  ///< where it begins
  std::unique_ptr<Problem> problem_;
};

/// Along the surest way through the edges, the pose of each submap in the frame of `from`, with the
/// covariance summed on the way (Dijkstra by its spread); loops with less than a tenth of their weight left
/// are not used (theory.md 10.6). The rest must connect all that have an edge; of others nothing is said.
std::vector<UncertainPose> relative_to(std::size_t from, const std::vector<Edge>& edges,
                                       const std::vector<Pose2>& poses);

/// Pose of submap `of` in the frame of `in`, with the covariance of all edges together: that of the linearised
/// graph, loops by the weight that is left to them. Both must have an edge, and be connected.
UncertainPose marginal(std::size_t of, std::size_t in, const std::vector<Edge>& edges,
                       const std::vector<Pose2>& poses);

}  // namespace bw::slam
