// Is a measurement sound by itself? Finite numbers, covariances that are ones, nothing no sensor could mean.
#pragma once

#include "components/localization/measurements.hpp"
#include "components/localization/verdict.hpp"
#include "runtime/base/field.hpp"

namespace bw::localization {

struct MeasurementLimits {
  double speed = 20.0;
  double turn_rate = 20.0;
  double wheel_interval = 1.0;
  double distance = 1e6;
  double variance = 1e6;

  template <class Visitor>
  void fields(Visitor& v) {
    v("speed", speed, {.unit = "m/s", .min = 0.01, .max = 1000, .doc = "faster wheels are a fault"});
    v("turn_rate", turn_rate,
      {.unit = "rad/s", .min = 0.01, .max = 1000, .doc = "a faster turn of wheels or gyro is a fault"});
    v("wheel_interval", wheel_interval,
      {.unit = "s", .min = 0.01, .max = 10, .doc = "a wheel step over a longer time is not an arc"});
    v("distance", distance,
      {.unit = "m", .min = 1, .max = 1e7, .doc = "positions further from the origin of map are a fault"});
    v("variance", variance,
      {.unit = "m^2", .min = 1, .max = 1e12, .doc = "larger variances mean 'unknown' and are not used"});
  }
};

/// Verdict::accepted when sound; else not_finite, bad_covariance, bad_interval, implausible or bad_source.
/// Sources are numbered from 0 to below `sources`.
Verdict check(const Measurement& measurement, const MeasurementLimits& limits, int sources = kUsualSources);

}  // namespace bw::localization
