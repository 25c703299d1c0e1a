// A message as a list of its values with their names.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "runtime/wire/type_description.hpp"

namespace bw {

using LeafValue = std::variant<bool, std::int64_t, std::uint64_t, double, std::string>;

struct Leaf {
  std::string path;  ///< pose.pose.position.x, ranges[17]; the length of a sequence is ranges.size()
  LeafValue value;
};

/// Every number and text of the message, in the order of the wire. Empty when validate() refuses the bytes.
[[nodiscard]] std::vector<Leaf> leaves_of(const TypeDescription& type, std::span<const std::uint8_t> cdr);

/// As people read it; a double with all its digits.
[[nodiscard]] std::string to_text(const LeafValue& value);

}  // namespace bw
