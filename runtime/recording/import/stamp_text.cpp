#include "runtime/recording/import/stamp_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "runtime/parameters/scalar_text.hpp"
#include "runtime/recording/import/units.hpp"

namespace bw::imports {
namespace {

constexpr double kLongest = 200.0 * 365.25 * 86400.0;  // [s]

/// Decimals of a nanosecond's multiple that the unit has; -1: it is none of the decimal ones.
int decimals_of(std::string_view unit) {
  if (unit == "s") return 9;
  if (unit == "ms") return 6;
  if (unit == "us") return 3;
  return unit == "ns" ? 0 : -1;
}

/// Of a plain decimal within kLongest.
std::int64_t exact_nanoseconds(std::string_view text, int decimals) {
  const bool negative = text.front() == '-';
  if (negative || text.front() == '+') text.remove_prefix(1);
  const std::size_t point = std::min(text.find('.'), text.size());
  std::int64_t sum = 0;
  for (const char c : text.substr(0, point)) sum = 10 * sum + (c - '0');
  const std::string_view fraction = text.substr(std::min(point + 1, text.size()));
  for (std::size_t i = 0; std::cmp_less(i, decimals); ++i)
    sum = 10 * sum + (i < fraction.size() ? fraction[i] - '0' : 0);
  const auto next = static_cast<std::size_t>(decimals);
  if (next < fraction.size() && fraction[next] >= '5') ++sum;
  return negative ? -sum : sum;
}

}  // namespace

std::optional<Duration> stamp_of_text(std::string_view text, std::string_view unit) {
  const std::optional<Unit> scale = unit_of(unit);
  const std::optional<double> number = parse_number(text);
  if (!scale || !number || !(std::abs(*number * scale->scale) <= kLongest)) return std::nullopt;
  const int decimals = decimals_of(unit);
  if (decimals < 0 || text.find_first_of("eE") != std::string_view::npos)
    return Duration::seconds(*number * scale->scale);
  return Duration{exact_nanoseconds(text, decimals)};
}

}  // namespace bw::imports
