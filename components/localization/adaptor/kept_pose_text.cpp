#include "components/localization/adaptor/kept_pose_text.hpp"

#include <array>
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

}  // namespace bw::localization
