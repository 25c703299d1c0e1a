#include "components/localization/kept_pose.hpp"

#include <cmath>

namespace bw::localization {
namespace {

constexpr double kFastest = 2.0;    // [m/s] that any base drives
constexpr double kJump = 0.2;       // [m] beside that
constexpr double kShare = 0.1;      // of the way and of the turn: standard deviation
constexpr double kPosition = 0.02;  // [m] standard deviation of what nobody measured
constexpr double kHeading = 0.02;   // [rad] the same

}  // namespace

std::optional<KeptPose> carried_on(const KeptPose& kept, const Pose2& X_OB, Time time) {
  const Pose2 moved = inverse(kept.X_OB) * X_OB;
  const double way = std::hypot(moved.x, moved.y);
  const double seconds = (time - kept.time).to_seconds();
  if (seconds < 0.0 || way > kFastest * seconds + kJump) return std::nullopt;
  KeptPose now{.time = time, .X_OB = X_OB, .X_MB = kept.X_MB * moved, .covariance = kept.covariance};
  // What the heading was wrong by has moved the position sideways.
  const double position = std::pow(kPosition + kShare * way, 2) + way * way * kept.covariance(2, 2);
  const double heading = std::pow(kHeading + kShare * std::abs(moved.theta), 2);
  now.covariance.diagonal() += Eigen::Vector3d(position, position, heading);
  return now;
}

}  // namespace bw::localization
