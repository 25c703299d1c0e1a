// What of a file is written for people: comments, the doc texts of options, and all of a README.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace bw::book {

/// A stretch of text that belongs together: a comment without its markers, a paragraph, a row of a table. Its
/// lines are joined by one space, so that a citation may be broken across them.
struct Passage {
  std::string text;
  std::vector<int> lines;  ///< of every character of `text`, from 1

  int line_at(std::size_t at) const { return at < lines.size() ? lines[at] : 0; }
  void append(char c, int line);
  void join_with_space(int line);
};

enum class Language {
  none,      ///< not looked at
  cpp,       ///< comments // and /* */, and the texts behind `.doc =`
  hash,      ///< comments from # to the end of the line
  markdown,  ///< everything; fenced blocks apart
};

Language language_of(const std::filesystem::path& file);

struct HumanText {
  std::vector<Passage> prose;
  std::vector<Passage> fenced;  ///< lines of fenced blocks of Markdown: commands and code, no citations
};

HumanText human_text(std::string_view content, Language language);

}  // namespace bw::book
