// A message as text, the way `ros2 topic echo` prints it (rosidl_runtime_py over PyYAML).
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "runtime/wire/type_description.hpp"

namespace bw {

/// YAML that ends with a newline and without the `---` between messages. Arrays and strings longer than 128
/// end in '...'. Bytes that validate() refuses become one comment line with the reason.
[[nodiscard]] std::string to_yaml(const TypeDescription& type, std::span<const std::uint8_t> cdr);

}  // namespace bw
