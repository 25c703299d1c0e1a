// Splits IDL text into words, each with its line; keeps include directives, which are all that ROS 2's
// own parser knows of a preprocessor, and comments after //, the only ones it knows.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bw::idl {

struct Token {
  enum class Type { kWord, kSymbol, kInclude, kEnd };
  Type type;
  std::string text;  ///< identifier or number, one symbol ("::" counts as one), or the included path
  int line;
  std::string comment;  ///< the lines of comment since the token before, each ended by a newline
};

/// The last token is kEnd. Throws std::runtime_error "<path>:<line>: ..." on text outside the subset.
[[nodiscard]] std::vector<Token> tokenize(std::string_view text, const std::string& path);

}  // namespace bw::idl
