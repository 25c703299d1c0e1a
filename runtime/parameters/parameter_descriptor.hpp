// What a person or a tool may know of a parameter before changing it, as
// rcl_interfaces/msg/ParameterDescriptor.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/field.hpp"
#include "runtime/parameters/parameter_value.hpp"

namespace bw {

struct DoubleRange {
  double from = 0.0;  ///< both inclusive
  double to = 0.0;
  bool operator==(const DoubleRange&) const = default;
};

struct IntegerRange {
  std::int64_t from = 0;
  std::int64_t to = 0;
  bool operator==(const IntegerRange&) const = default;
};

struct ParameterDescriptor {
  ParameterType type = ParameterType::not_set;
  std::string description;  ///< the field's documentation with its unit
  std::string
      additional_constraints;  ///< what a range cannot say: choices, one-sided rules, rules of list elements
  bool read_only = false;      ///< not now: see live_parameters.hpp
  std::optional<DoubleRange> double_range;
  std::optional<IntegerRange> integer_range;
};

/// `limits` are those of an integer's C++ type; `choices` the texts that the parameter may have (empty: any).
/// A range that is open at one end goes there to the end of the type.
ParameterDescriptor describe(ParameterType type, const Field& field, const IntegerRange& limits,
                             const std::vector<std::string_view>& choices);

}  // namespace bw
