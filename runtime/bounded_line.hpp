// std::getline for files that may hold anything: a line without an end is not read into memory.
#pragma once

#include <cstddef>
#include <istream>
#include <string>

namespace bw {

/// The next line without its '\n'; false at the end of the input. Of a line of more than `longest` characters
/// the first `longest` + 1, and the rest is left.
inline bool read_line(std::istream& input, std::string& text, std::size_t longest) {
  using Traits = std::istream::traits_type;
  text.clear();
  if (!input.good()) return false;
  try {
    while (text.size() <= longest) {
      const auto c = input.rdbuf()->sbumpc();
      if (Traits::eq_int_type(c, Traits::eof())) {
        input.setstate(text.empty() ? std::ios::eofbit | std::ios::failbit : std::ios::eofbit);
        return !text.empty();
      }
      if (Traits::to_char_type(c) == '\n') return true;
      text += Traits::to_char_type(c);
    }
  } catch (const std::ios::failure&) {  // such as a folder that was opened as a file
    input.setstate(std::ios::badbit);
    return false;
  }
  return true;
}

}  // namespace bw
