#include "runtime/wire/yaml_scalar.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <regex>

namespace bw {
namespace {

constexpr char32_t kReplacement = 0xFFFD;

/// Takes one character off the front of `rest`.
char32_t decode(std::string_view& rest) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(rest[i]); };
  const std::uint8_t lead = byte(0);
  const std::size_t length = lead < 0x80 ? 1 : lead < 0xC0 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  constexpr std::array<char32_t, 5> kSmallest = {0, 0, 0x80, 0x800,
                                                 0x10000};  // of each length: longer is a forgery
  char32_t value = length == 1 ? lead : lead & (0x7FU >> length);
  bool valid = length != 0 && lead < 0xF8 && length <= rest.size();
  for (std::size_t i = 1; valid && i < length; ++i) {
    valid = (byte(i) & 0xC0U) == 0x80U;
    value = value << 6U | (byte(i) & 0x3FU);
  }
  valid = valid && value >= kSmallest[length] && value <= 0x10FFFF && (value < 0xD800 || value > 0xDFFF);
  rest.remove_prefix(valid ? length : 1);
  return valid ? value : kReplacement;
}

void encode(char32_t c, std::string& out) {
  const auto tail = [&](unsigned shift) { out += static_cast<char>(0x80U | (c >> shift & 0x3FU)); };
  if (c < 0x80) {
    out += static_cast<char>(c);
  } else if (c < 0x800) {
    out += static_cast<char>(0xC0U | c >> 6U);
    tail(0);
  } else if (c < 0x10000) {
    out += static_cast<char>(0xE0U | c >> 12U);
    tail(6);
    tail(0);
  } else {
    out += static_cast<char>(0xF0U | c >> 18U);
    tail(12);
    tail(6);
    tail(0);
  }
}

bool is_break(char32_t c) { return c == '\n' || c == 0x85 || c == 0x2028 || c == 0x2029; }
bool is_blank(char32_t c) { return c == 0 || c == ' ' || c == '\t' || c == '\r' || is_break(c); }
bool is_printable_unicode(char32_t c) {
  return (c >= 0xA0 && c <= 0xD7FF) || (c >= 0xE000 && c <= 0xFFFD && c != 0xFEFF);
}
bool contains(std::string_view set, char32_t c) {
  return c < 0x80 && set.find(static_cast<char>(c)) != set.npos;
}

struct Allowed {
  bool plain = true;
  bool single_quoted = true;
};

/// YAML's rules on where its indicators, blanks and line breaks may stand.
Allowed allowed_styles(std::u32string_view text) {
  Allowed allowed;
  if (text.starts_with(U"---") || text.starts_with(U"...")) allowed.plain = false;
  const auto at_edge = [](char32_t c) { return c == ' ' || is_break(c); };
  if (at_edge(text.front()) || at_edge(text.back())) allowed.plain = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char32_t c = text[i];
    const bool blank_before = i == 0 || is_blank(text[i - 1]);
    const bool blank_after = i + 1 == text.size() || is_blank(text[i + 1]);
    if (i == 0 && contains("#,[]{}&*!|>'\"%@`", c)) allowed.plain = false;
    if (i == 0 && contains("?-", c) && blank_after) allowed.plain = false;
    if (c == ':' && blank_after) allowed.plain = false;
    if (c == '#' && blank_before) allowed.plain = false;
    if (is_break(c)) allowed.plain = false;
    const bool readable = c == '\n' || (c >= 0x20 && c <= 0x7E) || c == 0x85 || is_printable_unicode(c) ||
                          (c >= 0x10000 && c < 0x10FFFF);
    const bool break_beside_space =
        i > 0 && ((c == ' ' && is_break(text[i - 1])) || (is_break(c) && text[i - 1] == ' '));
    if (!readable || break_beside_space) allowed = {false, false};
  }
  return allowed;
}

/// Would YAML 1.1 read this plain text as null, a boolean, a number, a time, or one of its own signs?
bool means_something_else(const std::string& text) {
  static const std::regex pattern(
      "~|null|Null|NULL|<<|=|"
      "yes|Yes|YES|no|No|NO|true|True|TRUE|false|False|FALSE|on|On|ON|off|Off|OFF|"
      "[-+]?0b[0-1_]+|[-+]?0[0-7_]+|[-+]?(0|[1-9][0-9_]*)|[-+]?0x[0-9a-fA-F_]+|[-+]?[1-9][0-9_]*(:[0-5]?[0-9]"
      ")+|"
      "[-+]?[0-9][0-9_]*\\.[0-9_]*([eE][-+][0-9]+)?|\\.[0-9][0-9_]*([eE][-+][0-9]+)?|"
      "[-+]?[0-9][0-9_]*(:[0-5]?[0-9])+\\.[0-9_]*|[-+]?\\.(inf|Inf|INF)|\\.(nan|NaN|NAN)|"
      "[0-9]{4}-[0-9]{2}-[0-9]{2}|"
      "[0-9]{4}-[0-9]{1,2}-[0-9]{1,2}([Tt]|[ \\t]+)[0-9]{1,2}:[0-9]{2}:[0-9]{2}(\\.[0-9]*)?"
      "([ \\t]*(Z|[-+][0-9]{1,2}(:[0-9]{2})?))?",
      std::regex::optimize);
  constexpr std::size_t kLongest = 160;  // of any text that reaches us; std::regex recurses
  return text.empty() || (text.size() <= kLongest && std::regex_match(text, pattern));
}

std::string single_quoted(std::u32string_view text, std::size_t indent) {
  std::string out = "'";
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (is_break(text[i])) {
      // The first line feed of a run folds into a space when read, so it is written twice.
      if (text[i] == '\n' && (i == 0 || !is_break(text[i - 1]))) out += '\n';
      encode(text[i], out);
      if (i + 1 == text.size() || !is_break(text[i + 1])) out.append(indent, ' ');
    } else if (text[i] == '\'') {
      out += "''";
    } else {
      encode(text[i], out);
    }
  }
  return out + "'";
}

std::string double_quoted(std::u32string_view text) {
  constexpr std::string_view kCodes("\0\a\b\t\n\v\f\r\x1b\"\\", 11);
  constexpr std::string_view kLetters = "0abtnvfre\"\\";
  std::string out = "\"";
  for (const char32_t c : text) {
    const std::size_t code = c < 0x80 ? kCodes.find(static_cast<char>(c)) : kCodes.npos;
    if (code != kCodes.npos) {
      out += {'\\', kLetters[code]};
    } else if (c == 0x85 || c == 0x2028 || c == 0x2029) {
      out += c == 0x85 ? "\\N" : c == 0x2028 ? "\\L" : "\\P";
    } else if ((c >= 0x20 && c <= 0x7E) || is_printable_unicode(c)) {
      encode(c, out);
    } else {
      std::array<char, 12> escape{};
      const char* format = c <= 0xFF ? "\\x%02X" : c <= 0xFFFF ? "\\u%04X" : "\\U%08X";
      std::snprintf(escape.data(), escape.size(), format, static_cast<unsigned>(c));
      out += escape.data();
    }
  }
  return out + "\"";
}

}  // namespace

std::string yaml_number(double value) {
  if (std::isnan(value)) return ".nan";
  if (std::isinf(value)) return value > 0 ? ".inf" : "-.inf";
  std::array<char, 40> buffer{};
  const double size = std::abs(value);
  // The range in which Python writes no exponent.
  const bool fixed = size == 0 || (size >= 1e-4 && size < 1e16);
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 fixed ? std::chars_format::fixed : std::chars_format::scientific)
                       .ptr;
  std::string text(buffer.data(), end);
  if (text.find('.') == std::string::npos) text.insert(std::min(text.find('e'), text.size()), ".0");
  return text;
}

std::string yaml_text(std::string_view utf8, std::size_t limit, std::size_t indent) {
  std::u32string text;
  while (!utf8.empty() && text.size() < limit) text += decode(utf8);
  if (!utf8.empty()) text += U"...";
  if (text.empty()) return "''";
  const Allowed allowed = allowed_styles(text);
  std::string plain;
  for (const char32_t c : text) encode(c, plain);
  if (allowed.plain && !means_something_else(plain)) return plain;
  return allowed.single_quoted ? single_quoted(text, indent) : double_quoted(text);
}

}  // namespace bw
