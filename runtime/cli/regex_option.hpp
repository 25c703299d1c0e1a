// A regular expression of the command line.
#pragma once

#include <optional>
#include <regex>
#include <stdexcept>
#include <string>

namespace bw::cli {

/// Nothing for an empty text. Throws std::runtime_error that names the option and what is wrong.
inline std::optional<std::regex> to_regex(const std::string& option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  try {
    return std::regex(text);
  } catch (const std::regex_error& error) {
    throw std::runtime_error(option + " \"" + text + "\" is no regular expression: " + error.what());
  }
}

}  // namespace bw::cli
