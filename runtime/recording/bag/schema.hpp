// The text by which a bag explains a message type to whoever reads it (encoding `ros2msg`).
#pragma once

#include <string>

#include "runtime/wire/type_description.hpp"

namespace bw::bag {

/// The type's own definition, then each type that it contains, once, behind a line of 80 `=` and `MSG:
/// package/Name`.
[[nodiscard]] std::string schema_text(const TypeDescription& type);

}  // namespace bw::bag
