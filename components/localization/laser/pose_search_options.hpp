// Parameters of the search over the whole map.
#pragma once

#include "runtime/base/field.hpp"

namespace bw::localization {

struct PoseSearchOptions {
  /// [m] distance between positions that are tried (set by code alone)
  double step = 0.1;
  /// [rad] angle between headings that are tried
  static constexpr double kAngleStep = 0.035;
  /// [m] the base is never nearer than this to an obstacle of the map (set by code alone)
  double clearance = 0.1;
  /// poses that are reported at most
  static constexpr int kHypotheses = 20;
  /// [m] two poses nearer than this
  static constexpr double kApart = 0.5;
  /// [rad] poses near each other with less than this between their headings are one
  static constexpr double kApartAngle = 0.35;
  /// poses that fit worse are not reported
  static constexpr double kLeastFit = 0.4;
  /// poses that fit by so much worse than the best of the map are not reported
  static constexpr double kMargin = 0.25;
  /// how many coarse cells are looked into at most, the best first
  static constexpr int kCandidates = 20000;
};

}  // namespace bw::localization
