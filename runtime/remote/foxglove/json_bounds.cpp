#include "runtime/remote/foxglove/json_bounds.hpp"

namespace bw::foxglove {

std::optional<std::string> broken_bound(std::string_view text, std::size_t deepest, std::size_t most) {
  std::size_t depth = 0;
  std::size_t values = 1;
  bool is_in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') is_in_string = !is_in_string;
    if (is_in_string) {
      if (c == '\\') ++i;  // what follows ends nothing
      continue;
    }
    const bool opens = c == '[' || c == '{';
    if (opens && ++depth > deepest) return "nested deeper than " + std::to_string(deepest) + " levels";
    if ((c == ']' || c == '}') && depth > 0) --depth;
    // Each value but the first follows a comma, or is the first in what has been opened.
    if ((opens || c == ',') && ++values > most) return "of more than " + std::to_string(most) + " values";
  }
  return std::nullopt;
}

}  // namespace bw::foxglove
