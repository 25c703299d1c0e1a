// One parameter field: what a person needs to know about it. Written once, beside the default it describes:
//
//   struct MotorOptions {
//     double command_timeout = 0.2;
//     template <class Visitor>
//     void fields(Visitor& v) {
//       v("command_timeout", command_timeout, {.unit = "s", .min = 0.01, .max = 5, .doc = "maximum age"});
//     }
//   };
//
// That one list feeds YAML, validation, `bandwagon param`, the wire and the documentation. A field may be
// bool, int, std::int64_t, double, std::string, an enum with a table (choice.hpp), a nested struct with
// fields(), or a std::vector of any of these. A rule over several fields is `std::optional<std::string>
// violated_rule() const`, which returns the broken rule as a sentence. A name that was a field once is
// refused with what to do instead: `v.retired({"age"}, "set command_timeout")`. `static constexpr bool
// leaves_other_keys = true`: others read the same section too, and what is unknown here is theirs. Plain C++
// only: algorithms include this header.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bw {

/// Texts that somebody else holds: a list in braces, or a vector, for as long as the call of the visitor
/// lasts.
class Texts {
 public:
  Texts() = default;
  Texts(std::initializer_list<std::string_view> texts) : texts_(texts.begin(), texts.size()) {}
  Texts(const std::vector<std::string_view>& texts) : texts_(texts) {}

  bool empty() const { return texts_.empty(); }
  std::vector<std::string_view> all() const { return {texts_.begin(), texts_.end()}; }

 private:
  std::span<const std::string_view> texts_;
};

struct Field {
  std::string_view unit = {};                             ///< SI unit, empty when dimensionless
  double min = -std::numeric_limits<double>::infinity();  ///< smallest allowed number, inclusive
  double max = std::numeric_limits<double>::infinity();   ///< largest allowed number, inclusive
  bool infinity = false;  ///< .inf and -.inf are numbers here, as far as min and max allow
  Texts choices = {};     ///< allowed texts of a string; empty: any
  /// a file, read as relative to the YAML that names it; beside choices a text with a slash is one
  bool path = false;
  bool list_as_text = false;  ///< a list in YAML does as well: its text, "[[1, 2], [3, 4]]"
  std::string (*rule)(std::string_view text) = nullptr;  ///< why a text is refused; empty: it is not
  bool first = false;                                    ///< among the few that people turn first
  std::string_view doc = {};                             ///< one line: what it does, when to raise it
};

}  // namespace bw
