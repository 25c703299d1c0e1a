// What PING and ADC say, as ranges and voltage.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "components/robot_base/driver.hpp"
#include "components/robot_base/eddie/eddie_options.hpp"
#include "runtime/base/time.hpp"

namespace bw::eddie {

inline constexpr double kSonarMin = 0.02, kSonarMax = 3.0;       ///< [m] of a PING)))
inline constexpr double kInfraredMin = 0.2, kInfraredMax = 1.5;  ///< [m] of a Sharp GP2Y0A02
inline constexpr double kVoltsPerUnit = 5.0 / 4095.0;            ///< of ADC
inline constexpr std::size_t kAnalogChannels = 8, kSupplyChannel = 7;

/// Sonars first, then infrared ones.
inline std::vector<Ranger> rangers_of(const EddieOptions& options) {
  std::vector<Ranger> rangers;
  for (const std::string& frame : options.sonar_frames)
    rangers.push_back({frame, false, 0.35, kSonarMin, kSonarMax});
  for (const std::string& frame : options.infrared_frames)
    rangers.push_back({frame, true, 0.05, kInfraredMin, kInfraredMax});
  return rangers;
}

/// [m]; 0 is no echo.
inline double sonar_range(const EddieOptions& options, std::uint32_t value) {
  const double range = value * options.sonar_metres_per_unit;
  return value == 0 || range > kSonarMax ? std::numeric_limits<double>::infinity() : range;
}

/// [m]. Below its least range the sensor's voltage falls again: what is that near cannot be told from what is
/// further.
inline double infrared_range(const EddieOptions& options, std::uint32_t value) {
  const double range = options.infrared_scale * std::pow(value * kVoltsPerUnit, -options.infrared_power);
  return range <= kInfraredMax ? range : std::numeric_limits<double>::infinity();
}

inline void add_sonar(Time time, std::span<const std::uint32_t> values, const EddieOptions& options,
                      std::vector<RangeReading>& ranges) {
  for (std::size_t i = 0; i < values.size(); ++i)
    ranges.push_back({time, i, sonar_range(options, values[i])});
}

inline void add_infrared(Time time, std::span<const std::uint32_t> values, const EddieOptions& options,
                         std::vector<RangeReading>& ranges) {
  for (std::size_t i = 0; i < options.infrared_channels.size(); ++i) {
    const auto channel = static_cast<std::size_t>(options.infrared_channels[i] - 1);
    ranges.push_back({time, options.sonar_pins.size() + i, infrared_range(options, values[channel])});
  }
}

}  // namespace bw::eddie
