// Numbers as they stand in a report.
#pragma once

#include <cmath>

#include <nlohmann/json.hpp>

namespace bw::report {

/// With six significant digits; null for what is not finite.
inline nlohmann::ordered_json number_json(double value) {
  if (!std::isfinite(value)) return nullptr;
  if (value == 0.0) return 0.0;
  const double power = std::pow(10.0, 5.0 - std::floor(std::log10(std::abs(value))));
  return std::isfinite(power) && power > 0.0 ? std::round(value * power) / power : value;
}

}  // namespace bw::report
