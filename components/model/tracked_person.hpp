// Somebody as perceived: the one shape between tracker, predictor, their stand-in that cannot err, and
// messages. A planner reads the Mover in it.
#pragma once

#include <Eigen/Core>

#include "components/model/obstacles.hpp"
#include "runtime/base/time.hpp"

namespace bw {

/// At the stamp of the last sweep, in one frame that does not jump (odom, or the frame of the message). Ids
/// count from 1 and stay one person's, also of who was lost and is back; the position is between the legs.
struct TrackedPerson : Mover {
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< of (x, y, vx, vy) [m, m/s]
  Time born;                                             ///< first sweep that showed a part of them
  Time confirmed;                                        ///< first sweep after which they were reported
  Time last_seen;                                        ///< last sweep that showed a part of them
};

}  // namespace bw
