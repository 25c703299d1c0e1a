// What a request asks for, taken apart without trust.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace bw::web {

struct RequestTarget {
  std::string path;                   ///< decoded, from the first /: for looking up; its query is left away
  std::vector<std::string> segments;  ///< of the path, decoded; an empty last one where it ends with /
  std::optional<std::string> token;   ///< of the query, decoded; empty where it is not well written
};

/// The reason in words where it is refused: not beginning with /, an escape that is none, control characters,
/// /, \ or NUL hidden in an escape, a segment `.` or `..` or an empty one in the middle.
std::variant<RequestTarget, std::string> parse_target(std::string_view target);

/// One form field of `application/x-www-form-urlencoded`, decoded; empty where it is not there or not well
/// written.
std::string form_field(std::string_view body, std::string_view key);

/// For a log line: what people can read of it, at most 100 characters, without query.
std::string printable_path(std::string_view target);

}  // namespace bw::web
