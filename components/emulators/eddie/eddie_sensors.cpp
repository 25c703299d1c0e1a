#include "components/emulators/eddie/eddie_sensors.hpp"

#include <algorithm>

namespace bw::emulators {
namespace {

constexpr double kSonarReach = 2.9, kInfraredReach = 1.5;  // [m]
constexpr double kSonarHalfAngle = 0.35, kInfraredHalfAngle = 0.02;
constexpr double kFullScale = 4095.0, kVolts = 5.0;
constexpr std::uint32_t kRealBits = 0xFFC;
constexpr double kLeastPing = 0x12, kMaxPing = 0xB54;

}  // namespace

std::vector<Beam> eddie_beams() {
  const auto beam = [](double y, double theta, double half_angle, double reach) {
    return Beam{.X_base_sensor = {0.2, y, theta}, .half_angle = half_angle, .reach = reach};
  };
  return {beam(0.1, 0.26, kSonarHalfAngle, kSonarReach), beam(-0.1, -0.26, kSonarHalfAngle, kSonarReach),
          beam(0.06, 0.52, kInfraredHalfAngle, kInfraredReach),
          beam(-0.06, -0.52, kInfraredHalfAngle, kInfraredReach)};
}

std::uint32_t ping_value(double range, double units_per_mm) {
  const double value = range * 1000.0 * units_per_mm;
  return value >= kLeastPing && value <= kMaxPing ? static_cast<std::uint32_t>(std::lround(value)) : 0U;
}

std::uint32_t adc_value(double volts) {
  const double share = std::clamp(volts / kVolts, 0.0, 1.0);
  return static_cast<std::uint32_t>(std::lround(share * kFullScale)) & kRealBits;
}

double infrared_voltage(double range) {
  // d [cm] = 60.495 V^-1.1904 is the usual fit of that sensor's curve beyond 20 cm; nearer the curve falls
  // again, steeply.
  constexpr double kAt1V = 60.495, kPower = 1.1904, kPeak = 15.0;  // [cm]
  if (!std::isfinite(range) || range > kInfraredReach) return 0.3;
  const double centimetres = std::max(0.1, range * 100.0);
  const double volts = std::pow(kAt1V / std::max(centimetres, kPeak), 1.0 / kPower);
  return centimetres < kPeak ? volts * centimetres / kPeak : volts;
}

std::uint32_t supply_value(double volts) { return adc_value(volts / 3.21 * 819.0 / kFullScale * kVolts); }

}  // namespace bw::emulators
