#include "components/mapping/costmap/costmap_scan.hpp"

#include <cmath>
#include <numbers>

namespace bw::costmap {

const char* to_text(ScanStatus status) {
  switch (status) {
    case ScanStatus::used:
      return "used";
    case ScanStatus::bad_geometry:
      return "its angles or limits make no sweep";
    case ScanStatus::wrong_length:
      return "its beams do not fill its angles";
    case ScanStatus::bad_pose:
      return "its place is not finite";
    case ScanStatus::not_later:
      return "it is not later than the one before";
  }
  return "unknown";
}

ScanStatus check(const Scan& scan) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  constexpr double kLeastIncrement = 1e-5;  // [rad]; finer than any scanner, and a bound on the beams
  constexpr double kFarthest = 1e6;         // [m]
  const double span = scan.angle_max - scan.angle_min;
  if (!(std::abs(scan.angle_min) <= 2.0 * kTurn) || !(std::abs(span) <= kTurn + 0.01) ||
      !(std::abs(scan.angle_increment) >= kLeastIncrement && std::abs(scan.angle_increment) <= kTurn) ||
      !(scan.range_min >= 0.0 && scan.range_min < scan.range_max && scan.range_max <= kFarthest))
    return ScanStatus::bad_geometry;
  const double beams = span / scan.angle_increment + 1.0;
  if (scan.ranges.empty() || std::abs(static_cast<double>(scan.ranges.size()) - beams) > 1.5)
    return ScanStatus::wrong_length;
  if (!is_finite(scan.X_OL) || !(scan.X_OL.position().norm() <= kFarthest)) return ScanStatus::bad_pose;
  return ScanStatus::used;
}

}  // namespace bw::costmap
