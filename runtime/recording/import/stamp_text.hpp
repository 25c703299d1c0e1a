// A stamp in a table, to the nanosecond: a double has only microseconds left for a time of today.
#pragma once

#include <optional>
#include <string_view>

#include "runtime/base/time.hpp"

namespace bw::imports {

/// The number of `unit` (of unit_of(), a time) in the text, rounded to the nearest nanosecond. Decimals of s,
/// ms, us and ns are exact; other units and numbers with an exponent go through a double. Nothing for what is
/// no finite number, and beyond 200 years.
std::optional<Duration> stamp_of_text(std::string_view text, std::string_view unit);

}  // namespace bw::imports
