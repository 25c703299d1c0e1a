// One YAML document into a ConfigNode tree. The file is not trusted: its size, depth, number of values
// (aliases counted as often as they are used) and bytes are limited, and duplicate keys, tags, several
// documents and unprintable bytes are refused.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "runtime/parameters/config_node.hpp"

namespace bw {

inline constexpr std::size_t kMaxYamlBytes =
    1 << 20;  ///< of a file; of all its values after aliases four times this
inline constexpr std::size_t kMaxYamlNodes = 100'000;
inline constexpr std::size_t kMaxYamlDepth = 32;

/// Printable UTF-8, as a configuration may hold it.
bool is_config_text(std::string_view text);

/// Throws ConfigError with `file` and the line. `file` may be any name that a person recognises.
ConfigNode parse_yaml(std::string_view text, const std::string& file);

/// Throws ConfigError if the file cannot be read, too.
ConfigNode load_yaml(const std::filesystem::path& path);

}  // namespace bw
