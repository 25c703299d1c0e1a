// A message from text, as `ros2 topic pub` and `ros2 service call` take it: {pose: {position: {x: 1.0}}}.
// JSON is YAML too.
// What is not given is zero, empty, false; a quaternion that is not given is no rotation.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/parameters/config_node.hpp"
#include "runtime/wire/type_description.hpp"

namespace bw {

/// CDR with its encapsulation. Throws ConfigError with all keys that the type does not have and all values
/// that their field does not hold.
[[nodiscard]] std::vector<std::uint8_t> message_from_yaml(const TypeDescription& type,
                                                          const ConfigNode& text);

}  // namespace bw
