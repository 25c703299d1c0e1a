// Legs of a calibration, driven by odometry: straight on for a length, and rotations in place. They need not
// be exact: what counts is how far the wheels rotated and where the robot then stood.
#pragma once

#include <optional>

#include "runtime/base/pose2.hpp"

namespace bw {

struct LegOptions {
  double v = 0.3;                     ///< [m/s]
  double omega = 0.6;                 ///< [rad/s]
  double deceleration = 0.2;          ///< [m/s^2] towards the end of a leg: gently, so that no wheel slips
  double angular_deceleration = 0.5;  ///< [rad/s^2]
};

struct Leg {
  double distance = 0.0;  ///< straight on [m]; 0: a rotation
  double rotation = 0.0;  ///< in place, counter-clockwise [rad]
};

class LegDriver {
 public:
  LegDriver(const Leg& leg, const LegOptions& options, const Pose2& start);

  /// What to command at this pose of the odometry; nothing when the leg is over and the robot stands.
  std::optional<Twist2> step(const Pose2& X_OB, const Twist2& measured);
  /// More than this, and something holds the robot [s].
  double longest() const;

 private:
  Twist2 straight(const Pose2& X_OB);
  Twist2 rotate();

  Leg leg_;
  LegOptions options_;
  Pose2 start_;
  double heading_;        ///< last one seen
  double rotated_ = 0.0;  ///< since the start, unwrapped
  bool is_over_ = false;
};

}  // namespace bw
