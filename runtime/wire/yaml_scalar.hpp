// Single values as PyYAML writes them in block style, which is what ROS 2's tools print.
#pragma once

#include <string>
#include <string_view>

namespace bw {

/// Shortest text that reads back as the same double: 0.1, 1.0e-07, .nan, -.inf.
[[nodiscard]] std::string yaml_number(double value);

/// Plain where YAML would read it as this text, else quoted; broken UTF-8 becomes U+FFFD. More than `limit`
/// characters end in "...". `indent` [columns] is that of continued lines, should the text have any.
[[nodiscard]] std::string yaml_text(std::string_view utf8, std::size_t limit, std::size_t indent);

}  // namespace bw
