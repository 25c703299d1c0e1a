// What citations point to: numbered headings and the rows of tables, as the READMEs have them.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tests/book/citations.hpp"
#include "tests/book/human_text.hpp"

namespace bw::book {

/// The page with the index of sections; the page with the rows of faults.
inline constexpr std::string_view kFrontPage = "components/README.md";
inline constexpr std::string_view kFaultPage = "tests/README.md";

struct Place {
  std::string file;
  int line = 0;
};

/// Line of the index: section, and the page it is said to stand on (link from the front page's folder).
struct IndexEntry {
  std::string section;
  std::string page;
  int line = 0;
};

/// By key; several places for one key are a fault.
using Targets = std::map<std::string, std::vector<Place>>;

struct Book {
  std::map<CitationKind, Targets> targets;
  std::vector<IndexEntry> index;

  /// Adds the headings "## 6.2 Title" and the rows "| (3.12) | ...", "| D7 | ...", "| E3, E4 | ...",
  /// "| Table 3.2 | ..." of a page; of the fault page also "| 33 | ...", of the front page the index rows
  /// "| 6.2 | ... [page](link) ...".
  void add_page(const std::string& file, const HumanText& text);

  /// Adds the tests that a source file holds, as Suite.Name.
  void add_tests(const std::string& file, std::string_view content);

  /// Whether the citation resolves; a chapter does when it has a section.
  bool holds(CitationKind kind, const std::string& key) const;
};

}  // namespace bw::book
