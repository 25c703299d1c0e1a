// How deep and how large a JSON text is, before anything of it is built: a tree takes up to a hundred times
// what its text does.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace bw::foxglove {

/// The bound that is broken, such as "nested deeper than 16 levels" or "of more than 9 values"; nothing: at
/// most `deepest` arrays and objects lie within each other, and there are at most `most` values (an empty
/// array or object counts twice). Of a text that is no JSON, the same by its brackets and commas. Takes no
/// memory.
[[nodiscard]] std::optional<std::string> broken_bound(std::string_view text, std::size_t deepest,
                                                      std::size_t most);

}  // namespace bw::foxglove
