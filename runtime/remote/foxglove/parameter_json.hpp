// Values of parameters as the protocol writes them: JSON, with a type beside it where JSON alone would lose
// it (byte_array in base64, float64, float64_array).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include <nlohmann/json_fwd.hpp>

#include "runtime/parameters/parameter_set.hpp"

namespace bw::foxglove {

/// {name, value?, type?}. A value that is not set has none; infinities and NaN, which JSON does not have, are
/// strings.
nlohmann::ordered_json parameter_json(const NamedValue& parameter);

/// A sentence that follows the value: "must be ...".
struct BrokenRule {
  std::string_view text;
};

/// The value, or the rule that it breaks. Numbers with a point are doubles, whole ones integers unless `type`
/// says otherwise or others of the same list have a point; an empty list is one of strings.
std::variant<ParameterValue, BrokenRule> parameter_value_of(const nlohmann::json& value,
                                                            const std::optional<std::string>& type);

}  // namespace bw::foxglove
