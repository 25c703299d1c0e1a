// A message from JSON and as JSON, the way Foxglove's panels and services write it: {"header": {"stamp":
// {"sec": 1, "nanosec": 2}}}.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/wire/type_description.hpp"

namespace bw::foxglove {

/// CDR with its encapsulation. What is not given is zero; stamps may say `nsec`, headers a `seq`, as panels
/// do. Throws std::runtime_error naming what is wrong: no object, a field that the type does not have, a
/// value that its field does not hold, more than kMaxYamlNodes values, deeper than kMaxYamlDepth levels; the
/// last two before memory is taken for them.
[[nodiscard]] std::vector<std::uint8_t> message_from_json(const TypeDescription& type, std::string_view json);

/// Numbers that JSON does not have (NaN, infinity) are null; broken UTF-8 becomes U+FFFD. Throws
/// std::runtime_error when the bytes do not hold the message.
[[nodiscard]] std::string message_to_json(const TypeDescription& type, std::span<const std::uint8_t> cdr);

}  // namespace bw::foxglove
