// Follows a robot that has fallen silent by the laser: a disc of known radius, from where its last word left
// it.
//
// Each sweep: the disc moves on with its velocity; the points near its rim say where it truly is (least
// squares of their distances from the rim, Gauss-Newton); position and velocity follow by an alpha-beta
// filter. It is lost when too little of its rim was seen for a while.
#pragma once

#include <optional>
#include <vector>

#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw {

struct FollowedDisc {
  Time time;
  Vector2 position{0.0, 0.0};  ///< in the frame of the points, one that does not jump
  Vector2 velocity{0.0, 0.0};
  double deviation = 0.0;  ///< standard deviation of the position, each axis [m]
};

class LaserFollower {
 public:
  /// What is known of it for certain; its motion is followed from here.
  void start(const FollowedDisc& known) {
    disc_ = known;
    seen_ = known.time;
  }
  void forget() { disc_.reset(); }

  /// The disc at `time`, seen again or for less than a second not; nothing when it is lost or was never
  /// known, or without any point. `points`: hits of a sweep at `time`, in the frame of the disc; `radius`
  /// [m].
  std::optional<FollowedDisc> follow(const std::vector<Vector2>& points, double radius, Time time);

 private:
  std::optional<FollowedDisc> disc_;
  Time seen_;  ///< last sweep that showed it
};

/// The centre of the disc of this radius [m] whose rim the points near `guess` lie on; nothing when they are
/// few or on none.
std::optional<Vector2> disc_near(const Vector2& guess, const std::vector<Vector2>& points, double radius);

}  // namespace bw
