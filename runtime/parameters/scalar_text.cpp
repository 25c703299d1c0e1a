#include "runtime/parameters/scalar_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>

namespace bw {
namespace {

constexpr double kCentury = 3.2e9;  // [s]

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_word_character(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '/' ||
         c == '.' || c == '-';
}

/// A word that no YAML reader, of 1.1 or 1.2, takes for anything but text.
bool is_plain_word(std::string_view text) {
  constexpr std::array<std::string_view, 11> kReserved = {"true", "false", "yes", "no",  "on", "off",
                                                          "null", "y",     "n",   "inf", "nan"};
  if (text.empty() || is_digit(text[0]) || text[0] == '.' || text[0] == '-') return false;
  if (!std::all_of(text.begin(), text.end(), is_word_character)) return false;
  std::string lower;
  for (const char c : text) lower += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return std::find(kReserved.begin(), kReserved.end(), lower) == kReserved.end();
}

template <class T>
std::optional<T> parse_all(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const std::size_t digit = text.empty() || text[0] != '-' ? 0 : 1;
  // from_chars would take "inf", "nan" and their relatives, which YAML calls text.
  if (digit >= text.size() || !(is_digit(text[digit]) || text[digit] == '.')) return std::nullopt;
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<bool> parse_bool(std::string_view text) {
  if (text == "true" || text == "True" || text == "TRUE") return true;
  if (text == "false" || text == "False" || text == "FALSE") return false;
  return std::nullopt;
}

std::optional<std::int64_t> parse_integer(std::string_view text) { return parse_all<std::int64_t>(text); }

std::optional<double> parse_number(std::string_view text) {
  if (text == ".inf" || text == "+.inf") return std::numeric_limits<double>::infinity();
  if (text == "-.inf") return -std::numeric_limits<double>::infinity();
  if (text == ".nan") return std::numeric_limits<double>::quiet_NaN();
  return parse_all<double>(text);
}

namespace {

struct Unit {
  std::string_view name;
  double factor;
};

/// A number and the unit behind it, which may be missing; nothing if either is none.
std::optional<double> parse_with_unit(std::string_view text, std::span<const Unit> units) {
  std::size_t letter = text.size();
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  while (letter > 0 && is_letter(text[letter - 1])) --letter;
  double factor = 1.0;
  if (letter < text.size()) {
    const std::string_view name = text.substr(letter);
    const auto unit = std::ranges::find(units, name, &Unit::name);
    if (unit == units.end()) return std::nullopt;
    factor = unit->factor;
    text = text.substr(0, letter);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  }
  const std::optional<double> number = parse_number(text);
  if (!number || !std::isfinite(*number)) return std::nullopt;
  return *number * factor;
}

}  // namespace

std::optional<Duration> parse_duration(std::string_view text) {
  constexpr std::array<Unit, 5> kUnits = {
      {{"ns", 1e-9}, {"us", 1e-6}, {"ms", 1e-3}, {"s", 1.0}, {"min", 60.0}}};
  const std::optional<double> seconds = parse_with_unit(text, kUnits);
  if (!seconds || std::abs(*seconds) > kCentury) return std::nullopt;
  return Duration::seconds(*seconds);
}

std::optional<std::uint64_t> parse_size(std::string_view text) {
  constexpr std::array<Unit, 9> kUnits = {{{"B", 1.0},
                                           {"kB", 1e3},
                                           {"MB", 1e6},
                                           {"GB", 1e9},
                                           {"TB", 1e12},
                                           {"KiB", 0x1p10},
                                           {"MiB", 0x1p20},
                                           {"GiB", 0x1p30},
                                           {"TiB", 0x1p40}}};
  const std::optional<double> bytes = parse_with_unit(text, kUnits);
  if (!bytes || *bytes < 0.0 || *bytes >= 0x1p63) return std::nullopt;
  return static_cast<std::uint64_t>(std::llround(*bytes));
}

std::string to_text(bool value) { return value ? "true" : "false"; }

std::string to_text(std::int64_t value) { return std::to_string(value); }

std::string short_text(double value) {
  if (std::isnan(value)) return ".nan";
  if (std::isinf(value)) return value > 0 ? ".inf" : "-.inf";
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

std::string to_text(double value) {
  std::string text = short_text(value);
  const bool whole = std::all_of(text.begin(), text.end(), [](char c) { return is_digit(c) || c == '-'; });
  return whole ? text + ".0" : text;
}

std::string to_text(const std::string& value) {
  if (is_plain_word(value)) return value;
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : value) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += {'\\', c};
    } else if (byte < 0x20) {
      out += {'\\', 'x', kHex[byte >> 4], kHex[byte & 15]};
    } else {
      out += c;
    }
  }
  return out + '"';
}

}  // namespace bw
