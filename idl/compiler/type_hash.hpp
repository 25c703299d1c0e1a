// The ROS 2 type hash RIHS01 (REP 2011): SHA-256 of a JSON text that names every field of a type and of all
// types it reaches.
#pragma once

#include <string>

#include "idl/compiler/parser.hpp"

namespace bw::idl {

/// The text that is hashed. `type` and all it reaches must be in `types`.
[[nodiscard]] std::string type_description_json(const Struct& type, const Types& types);

/// "RIHS01_" and 64 hexadecimal digits.
[[nodiscard]] std::string type_hash(const Struct& type, const Types& types);

}  // namespace bw::idl
