#include "components/slam/adaptor/health_text.hpp"

#include <numbers>

#include <fmt/format.h>

namespace bw::slam {

std::string to_text(const SlamHealth& health) {
  switch (health.cause) {
    case HealthCause::none:
      return "mapping";
    case HealthCause::no_scan:
      return "waits for scans and odometry";
    case HealthCause::kidnapped:
      return "kidnapped: all at once scans do not meet the map; nothing is drawn";
    case HealthCause::odometry_jump:
      return fmt::format("odometry jumped by {:.1f} m between two scans", health.value);
    case HealthCause::no_features:
      return "no features: the scan shows hardly a wall; by odometry";
    case HealthCause::no_match:
      return "the scan does not meet the map: by odometry";
    case HealthCause::slip:
      return fmt::format("slipping: {:.2f} m in the last second by odometry, {:.2f} m by scans", health.value,
                         health.by_scans);
    case HealthCause::turn_slip:
      return fmt::format("slipping: turned by {:.2f} rad in the last second by odometry, {:.2f} rad by scans",
                         health.value, health.by_scans);
    case HealthCause::unseen:
      return fmt::format("walls do not show where the robot is along {:.0f} deg of the map: by odometry",
                         health.value * 180.0 / std::numbers::pi);
  }
  return "";
}

}  // namespace bw::slam
