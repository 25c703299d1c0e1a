// Errors of a trajectory by relations between its poses: Kümmerle, Steder, Dornhege, Ruhnke, Grisetti,
// Stachniss, Kleiner, "On measuring the accuracy of SLAM algorithms", Autonomous Robots 27, 2009. No frame is
// shared with a truth, and an error early in the drive counts once.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw::slam {

/// Where base_link was at `to`, seen from where it was at `from`.
struct Relation {
  Time from;
  Time to;
  Pose2 X;
};

/// Mean and standard deviation over the relations.
struct RelationErrors {
  std::size_t relations = 0;
  double translation = 0.0;  ///< [m]
  double translation_deviation = 0.0;
  double rotation = 0.0;  ///< [rad]
  double rotation_deviation = 0.0;
};

/// What of the relation the two poses, in one frame, do not say: inverse(relation) * (X_1 seen to X_2).
Pose2 error_of(const Relation& relation, const Pose2& X_from, const Pose2& X_to);

/// Of relations whose both poses `pose_at` knows.
RelationErrors errors_of(const std::vector<Relation>& relations,
                         const std::function<std::optional<Pose2>(Time)>& pose_at);

}  // namespace bw::slam
