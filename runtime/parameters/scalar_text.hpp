// Scalars between text and value, the way YAML 1.2 writes them, without locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "runtime/base/time.hpp"

namespace bw {

std::optional<bool> parse_bool(std::string_view text);             ///< true, false
std::optional<std::int64_t> parse_integer(std::string_view text);  ///< decimal; nothing if it does not fit
std::optional<double> parse_number(std::string_view text);         ///< decimal, .inf, -.inf, .nan
/// `20ms`, `250 us`, `0.02s`, `10 min`, or seconds without a unit; finite, and below 100 years.
std::optional<Duration> parse_duration(std::string_view text);

/// `100MB`, `1.5 GiB`, `500 kB`, or bytes without a unit: whole bytes, below 2^63.
std::optional<std::uint64_t> parse_size(std::string_view text);

std::string to_text(bool value);
std::string to_text(std::int64_t value);
/// The shortest text that reads back as the same number and as no integer: 1.0, 0.1, 1e-09, .inf.
std::string to_text(double value);
/// As to_text, but whole numbers without ".0": for messages.
std::string short_text(double value);
/// Quoted unless it is a plain word that reads back as text.
std::string to_text(const std::string& value);

}  // namespace bw
