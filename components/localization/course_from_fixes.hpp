// Course over ground from position fixes, for receivers that do not give it (ekf/theory.md 3.2).
#pragma once

#include <cmath>
#include <optional>

#include "components/localization/measurements.hpp"

namespace bw::localization {

struct CourseLimits {
  double speed = 0.3;    ///< slower between two fixes says nothing [m/s]
  double sigma = 0.3;    ///< fixes are far enough apart when the course is known this well [rad]
  double longest = 3.0;  ///< [s] between them; must stay below twice the filter's window
};

/// The direction from one fix to a later one, stamped half way: there an arc has the heading of its chord.
/// Variance (s1^2 + s2^2) / distance^2, s the larger axis. Each fix ends one course and begins the next, so
/// that courses in a row are correlated by -1/2, and with the fixes themselves: use either fixes or courses
/// where the heading must be consistent to more than a factor. The antenna's arm is taken for zero.
class CourseFromFixes {
 public:
  CourseFromFixes(int source, const CourseLimits& limits) : source_(source), limits_(limits) {}

  /// Fixes in order of their stamps.
  std::optional<CourseReading> add(const PositionFix& fix) {
    const PositionFix from = from_;
    if (!begun_ || fix.time <= from.time || (fix.time - from.time).to_seconds() > limits_.longest) {
      begun_ = true;
      from_ = fix;
      return std::nullopt;
    }
    const Duration over = fix.time - from.time;
    const Vector2 offset = fix.position - from.position;
    const double distance = offset.norm();
    const double sum = from.covariance.diagonal().maxCoeff() + fix.covariance.diagonal().maxCoeff();
    if (distance * limits_.sigma < std::sqrt(sum)) return std::nullopt;
    from_ = fix;
    if (distance < limits_.speed * over.to_seconds()) return std::nullopt;
    return CourseReading{from.time + Duration{over.nanoseconds / 2}, source_,
                         std::atan2(offset.y(), offset.x()), sum / (distance * distance)};
  }

 private:
  int source_;
  CourseLimits limits_;
  bool begun_ = false;
  PositionFix from_;
};

}  // namespace bw::localization
