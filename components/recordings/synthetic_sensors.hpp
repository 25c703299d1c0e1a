// A receiver and a compass made from a log's reference poses, for logs that have none
// (experiments/protocols.md 8.7).
#pragma once

#include <cstdint>

#include "components/recordings/recorded_drive.hpp"
#include "runtime/base/field.hpp"

namespace bw {

struct SyntheticSensorOptions {
  /// [Hz] fixes per second; 0: no receiver (set by code alone)
  double gps_rate = 1.0;
  double gps_noise = 0.2;
  /// [Hz] readings per second; 0: no compass (set by code alone)
  double compass_rate = 10.0;
  double compass_noise = 0.01745;

  template <class Visitor>
  void fields(Visitor& v) {
    v("gps_noise", gps_noise, {.unit = "m", .min = 0.001, .max = 100, .doc = "standard deviation per axis"});
    v("compass_noise", compass_noise,
      {.unit = "rad", .min = 0.0001, .max = 3.2, .doc = "standard deviation of the compass"});
  }
};

/// Adds fixes around `datum` and headings while the wheels are heard and the reference has no gap over half a
/// second. Noise is white and normal; the same seed gives the same noise of each sensor whatever the other
/// does.
void add_synthetic_sensors(RecordedDrive& drive, const SyntheticSensorOptions& options,
                           const localization::Geodetic& datum, std::uint64_t seed);

}  // namespace bw
