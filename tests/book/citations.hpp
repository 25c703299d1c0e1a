// Citations in the text of comments and READMEs. The grammar is told in components/README.md (book 1.2).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bw::book {

enum class CitationKind {
  section,     ///< book 6.2, book 6.1 to 6.7, and chapters: book 3
  equation,    ///< (3.12), equation 3.12
  decision,    ///< D7
  experiment,  ///< E3
  fault,       ///< row 33, rows 6 to 8
  table,       ///< Table 3.2
  figure,      ///< Figure 3.8b, Figures 3.7, 3.11
  algorithm,   ///< Algorithm 1
  path,        ///< components/model/planning.hpp, config/robots/*.yaml: from the project's folder
  link,        ///< Markdown's [text](target), from the file's own folder
  test,        ///< `Suite.Name` of a GoogleTest test
  forbidden,   ///< names a text that is not in the tree
};

struct Citation {
  CitationKind kind = CitationKind::section;
  std::string key;     ///< what it must be found by: 6.2, 3.12, D7, E3, 33, a path
  std::size_t at = 0;  ///< where in the text it stands
};

/// All of them, in no particular order. A number counts as an equation only when it stands alone in
/// parentheses, has a chapter of the dissertation (1 to 3) before its dot and one or two digits behind it,
/// and no name or bracket stands right before: f(1.5) and (0.5) are none.
std::vector<Citation> citations_in(std::string_view text);

/// What also counts in Markdown: links, and tests in backticks.
std::vector<Citation> markdown_citations_in(std::string_view text);

/// Paths alone: what is looked for in fenced blocks.
std::vector<Citation> paths_in(std::string_view text);

}  // namespace bw::book
