// Is a measurement sound by itself? Finite numbers, covariances that are ones, nothing no sensor could mean.
#pragma once

#include "components/localization/measurements.hpp"
#include "components/localization/verdict.hpp"
#include "runtime/base/field.hpp"

namespace bw::localization {

struct MeasurementLimits {
  /// [m/s] faster wheels are a fault
  double speed = 20.0;
  /// [rad/s] a faster rotation of wheels or gyro is a fault
  double turn_rate = 20.0;
  /// [s] a wheel step over a longer time is not an arc
  double wheel_interval = 1.0;
  /// [m] positions further from the origin of map are a fault
  double distance = 1e6;
  /// [m^2] larger variances mean 'unknown' and are not used
  double variance = 1e6;
};

/// Verdict::accepted when sound; else not_finite, bad_covariance, bad_interval, implausible or bad_source.
/// Sources are numbered from 0 to below `sources`.
Verdict check(const Measurement& measurement, const MeasurementLimits& limits, int sources = kUsualSources);

}  // namespace bw::localization
