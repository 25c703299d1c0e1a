#include "components/localization/adaptor/kept_pose.hpp"

#include <array>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

namespace bw::localization {

std::string to_text(const KeptPose& kept) {
  const Eigen::Matrix3d& P = kept.covariance;
  return fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {}\n", kept.time.nanoseconds, kept.X_OB.x,
                     kept.X_OB.y, kept.X_OB.theta, kept.X_MB.x, kept.X_MB.y, kept.X_MB.theta, P(0, 0),
                     P(0, 1), P(0, 2), P(1, 1), P(1, 2), P(2, 2));
}

std::optional<KeptPose> kept_pose(const std::string& text) {
  std::istringstream in(text);
  KeptPose kept;
  std::array<double, 12> v{};
  in >> kept.time.nanoseconds;
  for (double& value : v) in >> value;
  if (!in) return std::nullopt;
  kept.X_OB = {v[0], v[1], v[2]};
  kept.X_MB = {v[3], v[4], v[5]};
  kept.covariance << v[6], v[7], v[8], v[7], v[9], v[10], v[8], v[10], v[11];
  const bool is_sound = is_finite(kept.X_OB) && is_finite(kept.X_MB) && kept.covariance.allFinite() &&
                        kept.covariance.diagonal().minCoeff() > 0.0;
  return is_sound ? std::optional(kept) : std::nullopt;
}

std::optional<KeptPose> carried_on(const KeptPose& kept, const Pose2& X_OB, Time time) {
  constexpr double kFastest = 2.0, kJump = 0.2, kShare = 0.1, kPosition = 0.02, kHeading = 0.02;
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
