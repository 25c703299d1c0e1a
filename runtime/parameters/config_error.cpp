#include "runtime/parameters/config_error.hpp"

#include <algorithm>
#include <utility>

namespace bw {
namespace {

constexpr std::size_t kMaxLines = 50;
constexpr std::size_t kMaxText = 120;

/// Keys and values come from files: no control characters on the terminal, no screenful of one value.
std::string printable(std::string_view text) {
  std::string out;
  for (const char c : text.substr(0, kMaxText)) {
    const auto byte = static_cast<unsigned char>(c);
    out += byte < 0x20 || byte == 0x7f ? '?' : c;
  }
  if (text.size() > kMaxText) out += "...";
  return out;
}

/// Each once: a section such as `robot` is read by every component that uses it.
std::string lines_of(const std::vector<Violation>& violations) {
  std::vector<std::string> lines;
  for (const Violation& violation : violations) {
    std::string line = violation.text();
    if (std::ranges::find(lines, line) == lines.end()) lines.push_back(std::move(line));
  }
  std::string out;
  for (std::size_t i = 0; i < std::min(lines.size(), kMaxLines); ++i) {
    if (i > 0) out += '\n';
    out += lines[i];
  }
  if (lines.size() > kMaxLines) out += "\nand " + std::to_string(lines.size() - kMaxLines) + " more";
  return out;
}

}  // namespace

std::string Location::text() const {
  return line > 0 && file != kOverrideFile ? file + ":" + std::to_string(line) : file;
}

std::string Violation::text() const {
  std::string out = where.text() + ": ";
  if (!key.empty()) out += printable(key) + (value.empty() ? ": " : " = " + printable(value) + ": ");
  return out + rule;
}

ConfigError::ConfigError(std::vector<Violation> violations)
    : std::runtime_error(lines_of(violations)), violations_(std::move(violations)) {}

ConfigError::ConfigError(Violation violation) : ConfigError(std::vector<Violation>{std::move(violation)}) {}

void throw_if_any(std::vector<Violation> violations) {
  if (!violations.empty()) throw ConfigError(std::move(violations));
}

}  // namespace bw
