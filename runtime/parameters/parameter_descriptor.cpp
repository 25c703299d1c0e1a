#include "runtime/parameters/parameter_descriptor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/parameters/nearest.hpp"
#include "runtime/parameters/read_parameters.hpp"

namespace bw {
namespace {

/// Casting is defined between the ends alone.
std::int64_t within(double bound, const IntegerRange& limits) {
  if (bound >= static_cast<double>(limits.to)) return limits.to;
  if (bound <= static_cast<double>(limits.from)) return limits.from;
  return static_cast<std::int64_t>(bound);
}

bool is_list(ParameterType type) { return type >= ParameterType::byte_list; }

}  // namespace

ParameterDescriptor describe(ParameterType type, const Field& field, const IntegerRange& limits,
                             const std::vector<std::string_view>& choices) {
  ParameterDescriptor descriptor{.type = type};
  descriptor.description = std::string(field.doc);
  if (!field.unit.empty())
    descriptor.description.append(field.doc.empty() ? "[" : " [").append(field.unit).append("]");
  const bool low = std::isfinite(field.min), high = std::isfinite(field.max);
  if (type == ParameterType::floating_point && (low || high)) {
    // Where infinity is a number, an open end is open.
    constexpr double kMax = std::numeric_limits<double>::max();
    const double most = field.infinity ? std::numeric_limits<double>::infinity() : kMax;
    descriptor.double_range = {std::max(field.min, -most), std::min(field.max, most)};
  }
  if (type == ParameterType::integer && (low || high))
    descriptor.integer_range = {within(std::ceil(field.min), limits), within(std::floor(field.max), limits)};

  if (!choices.empty()) {
    descriptor.additional_constraints = "must be one of " + comma_separated(choices);
  } else if ((low != high && !is_list(type)) || ((low || high) && is_list(type))) {
    descriptor.additional_constraints = (is_list(type) ? "each element " : "") + range_rule(field);
  }
  return descriptor;
}

}  // namespace bw
