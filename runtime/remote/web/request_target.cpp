#include "runtime/remote/web/request_target.hpp"

#include <algorithm>
#include <optional>

namespace bw::web {
namespace {

int digit_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::optional<std::string> decoded(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      out += text[i];
      continue;
    }
    if (i + 2 >= text.size()) return std::nullopt;
    const int high = digit_of(text[i + 1]);
    const int low = digit_of(text[i + 2]);
    if (high < 0 || low < 0) return std::nullopt;
    out += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return out;
}

bool is_control(char c) { return static_cast<unsigned char>(c) < 32 || c == 127; }

/// Why the segment is refused, or empty.
std::string_view wrong_with(std::string_view segment, bool is_last) {
  if (segment == "." || segment == "..") return "a path has no . and no ..";
  if (segment.empty() && !is_last) return "a path has no empty parts";
  if (segment.find_first_of("/\\") != std::string_view::npos) return "a part of a path has no / and no \\";
  if (std::any_of(segment.begin(), segment.end(), is_control)) return "a path has no control characters";
  return {};
}

std::optional<std::string> value_of(std::string_view query, std::string_view key) {
  while (!query.empty()) {
    const std::string_view pair = query.substr(0, query.find('&'));
    query.remove_prefix(std::min(query.size(), pair.size() + 1));
    const std::string_view name = pair.substr(0, pair.find('='));
    if (decoded(name) != key) continue;
    return name == pair ? "" : decoded(pair.substr(name.size() + 1)).value_or("");
  }
  return std::nullopt;
}

}  // namespace

std::variant<RequestTarget, std::string> parse_target(std::string_view target) {
  if (!target.starts_with('/')) return std::string("what is asked for begins with /");
  RequestTarget result;
  const std::size_t question = target.find('?');
  if (question != std::string_view::npos) result.token = value_of(target.substr(question + 1), "token");
  std::string_view rest = target.substr(0, question);
  while (!rest.empty()) {
    rest.remove_prefix(1);  // the slash
    const std::string_view raw = rest.substr(0, rest.find('/'));
    rest.remove_prefix(raw.size());
    auto segment = decoded(raw);
    if (!segment) return std::string("% in a path is followed by two hexadecimal digits");
    if (const auto wrong = wrong_with(*segment, rest.empty()); !wrong.empty()) return std::string(wrong);
    result.path += '/' + *segment;
    result.segments.push_back(std::move(*segment));
  }
  return result;
}

std::string form_field(std::string_view body, std::string_view key) {
  while (!body.empty()) {
    const std::string_view pair = body.substr(0, body.find('&'));
    body.remove_prefix(std::min(body.size(), pair.size() + 1));
    const std::size_t equals = pair.find('=');
    if (equals == std::string_view::npos || pair.substr(0, equals) != key) continue;
    std::string value(pair.substr(equals + 1));
    std::replace(value.begin(), value.end(), '+', ' ');
    return decoded(value).value_or("");
  }
  return {};
}

std::string printable_path(std::string_view target) {
  std::string text(target.substr(0, target.find('?')).substr(0, 100));
  for (char& c : text) {
    if (is_control(c) || static_cast<unsigned char>(c) > 126) c = '?';
  }
  return text;
}

}  // namespace bw::web
