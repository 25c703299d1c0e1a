// The known name that a mistyped one probably meant.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bw {

/// The known name with the smallest edit distance, if that is small against its length; the first of equals.
std::optional<std::string_view> nearest_of(std::string_view name, const std::vector<std::string_view>& known);

/// "unknown <what>; did you mean 'rate'?" or, when nothing is near, "unknown <what>; known: a, b".
std::string unknown_rule(std::string_view what, std::string_view name,
                         const std::vector<std::string_view>& known);

/// "a, b, c"
std::string comma_separated(const std::vector<std::string_view>& names);

}  // namespace bw
