// A type in the text form of ROS 2's .msg files.
#pragma once

#include <string>
#include <vector>

#include "idl/compiler/model.hpp"

namespace bw::idl {

/// "# " before each line.
[[nodiscard]] std::string comment_lines(const std::string& comment);

/// Constants and fields, a line each, below their comments; nested types as `package/Name`. Of a type without
/// fields one comment.
[[nodiscard]] std::string msg_text(const Struct& type, const std::vector<Constants>& constants_of_file);

}  // namespace bw::idl
