// Elementary functions without branches or calls, so that loops over them vectorise.
#pragma once

#include <bit>
#include <cstdint>
#include <numbers>

namespace bw::localization {

struct SinCos {
  float sin;
  float cos;
};

/// Absolute errors below 3e-7 for |angle| <= 100 rad.
[[gnu::always_inline]] inline SinCos sin_cos(float angle) {
  // pi/2 in three parts, the first two with so few digits that their multiples are exact.
  constexpr float kFirst = 1.5703125F;
  constexpr float kSecond = 4.83751296997e-4F;
  constexpr float kThird = 7.54978995489e-8F;
  const float exact = angle * 0.636619772F;
  const auto quarter = static_cast<std::int32_t>(exact + (exact < 0.0F ? -0.5F : 0.5F));
  const auto quarters = static_cast<float>(quarter);
  const float r = ((angle - quarters * kFirst) - quarters * kSecond) - quarters * kThird;
  const float q = r * r;
  // Taylor series; the first term left out is below 4e-8 for |r| <= pi/4.
  const float s = r + r * q * (-1.0F / 6 + q * (1.0F / 120 + q * (-1.0F / 5040 + q * (1.0F / 362880))));
  const float c = 1.0F + q * (-0.5F + q * (1.0F / 24 + q * (-1.0F / 720 + q * (1.0F / 40320))));
  const bool swapped = (quarter & 1) != 0;
  const float sine = swapped ? c : s;
  const float cosine = swapped ? s : c;
  return {(quarter & 2) != 0 ? -sine : sine, ((quarter + 1) & 2) != 0 ? -cosine : cosine};
}

/// Natural logarithm of a normal number above 0; absolute error below 1e-6.
[[gnu::always_inline]] inline float fast_log(float value) {
  const auto bits = std::bit_cast<std::int32_t>(value);
  // Mantissa into [sqrt(1/2), sqrt(2)): near 1 the series is short.
  const std::int32_t exponent = (bits - 0x3f3504f3) >> 23;
  const float m = std::bit_cast<float>(bits - exponent * (1 << 23));
  const float t = (m - 1.0F) / (m + 1.0F);  // ln m = 2 artanh t, |t| <= 0.172
  const float q = t * t;
  const float series = 2.0F + q * (2.0F / 3 + q * (2.0F / 5 + q * (2.0F / 7 + q * (2.0F / 9))));
  return t * series + static_cast<float>(exponent) * std::numbers::ln2_v<float>;
}

/// exp of a value <= 0, relative error below 1e-6; 0 below -87.
[[gnu::always_inline]] inline float fast_exp(float value) {
  constexpr float kRounder = 12582912.0F;  // 1.5 * 2^23: adding it drops the fraction
  const float x = value < -87.0F ? -87.0F : value;
  const float halvings = (x * std::numbers::log2e_v<float> + kRounder) - kRounder;
  const float r = (x - halvings * 0.693359375F) + halvings * 2.12194440e-4F;  // ln 2 in two parts
  const float series =
      1.0F +
      r * (1.0F + r * (1.0F / 2 + r * (1.0F / 6 + r * (1.0F / 24 + r * (1.0F / 120 + r * (1.0F / 720))))));
  const std::int32_t bits = (static_cast<std::int32_t>(halvings) + 127) * (1 << 23);
  const float result = series * std::bit_cast<float>(bits);
  return value < -87.0F ? 0.0F : result;
}

/// Any angle below 1e6 rad to [-pi, pi].
[[gnu::always_inline]] inline double fast_wrap(double angle) {
  constexpr double kRounder = 6755399441055744.0;  // 1.5 * 2^52
  const double revolutions = (angle * (0.5 * std::numbers::inv_pi) + kRounder) - kRounder;
  return angle - revolutions * (2.0 * std::numbers::pi);
}

}  // namespace bw::localization
