#include "tests/book/targets.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace bw::book {
namespace {

bool is_number(std::string_view text, std::size_t dots) {
  std::size_t seen = 0;
  if (text.empty() || text.front() == '.' || text.back() == '.') return false;
  for (const char c : text) {
    if (c == '.') ++seen;
    if (c != '.' && std::isdigit(static_cast<unsigned char>(c)) == 0) return false;
  }
  return seen == dots;
}

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

/// The number of a heading "## 6.2 Title", or nothing.
std::string_view heading_number(std::string_view text) {
  if (!text.starts_with('#')) return {};
  text.remove_prefix(std::min(text.find_first_not_of('#'), text.size()));
  text = trimmed(text);
  const std::string_view number = text.substr(0, text.find(' '));
  return is_number(number, 1) ? number : std::string_view();
}

std::string_view first_cell(std::string_view row) {
  if (!row.starts_with('|')) return {};
  row.remove_prefix(1);
  return trimmed(row.substr(0, row.find('|')));
}

/// How a table names what it defines.
std::string as_defined(const Citation& citation) {
  switch (citation.kind) {
    case CitationKind::equation:
      return "(" + citation.key + ")";
    case CitationKind::decision:
    case CitationKind::experiment:
      return citation.key;
    case CitationKind::table:
      return "Table " + citation.key;
    case CitationKind::figure:
      return "Figure " + citation.key;
    case CitationKind::algorithm:
      return "Algorithm " + citation.key;
    default:
      return {};
  }
}

/// What a cell defines that holds nothing else: "(3.12)", "E3, E4".
std::vector<Citation> defined_by(std::string_view cell) {
  std::vector<Citation> defined;
  while (!cell.empty()) {
    const std::size_t comma = std::min(cell.find(','), cell.size());
    const std::string_view piece = trimmed(cell.substr(0, comma));
    cell.remove_prefix(std::min(comma + 1, cell.size()));
    const std::vector<Citation> citations = citations_in(piece);
    if (citations.size() != 1 || as_defined(citations[0]) != piece) return {};
    defined.push_back(citations[0]);
  }
  return defined;
}

std::string link_in(std::string_view row) {
  for (const Citation& citation : markdown_citations_in(row)) {
    if (citation.kind == CitationKind::link) return citation.key;
  }
  return {};
}

}  // namespace

void Book::add_page(const std::string& file, const HumanText& text) {
  for (const Passage& passage : text.prose) {
    const int line = passage.line_at(0);
    const auto add = [&](CitationKind kind, std::string_view key) {
      targets[kind][std::string(key)].push_back({file, line});
    };
    if (const std::string_view number = heading_number(passage.text); !number.empty())
      add(CitationKind::section, number);
    const std::string_view cell = first_cell(passage.text);
    if (cell.empty()) continue;
    if (file == kFrontPage && is_number(cell, 1))
      index.push_back({std::string(cell), link_in(passage.text), line});
    if (file == kFaultPage && is_number(cell, 0)) add(CitationKind::fault, cell);
    for (const Citation& citation : defined_by(cell)) add(citation.kind, citation.key);
  }
}

void Book::add_tests(const std::string& file, std::string_view content) {
  for (const std::string_view macro :
       {std::string_view("\nTEST("), std::string_view("\nTEST_F("), std::string_view("\nTEST_P(")}) {
    for (std::size_t at = content.find(macro); at != std::string_view::npos;
         at = content.find(macro, at + 1)) {
      std::string_view arguments = content.substr(at + macro.size());
      arguments = arguments.substr(0, arguments.find(')'));
      const std::size_t comma = arguments.find(',');
      if (comma == std::string_view::npos) continue;
      std::string_view name = arguments.substr(comma + 1);
      while (name.starts_with(' ') || name.starts_with('\n')) name.remove_prefix(1);
      const std::string key = std::string(trimmed(arguments.substr(0, comma))) + "." + std::string(name);
      targets[CitationKind::test][key].push_back({file, 0});
    }
  }
}

bool Book::holds(CitationKind kind, const std::string& key) const {
  const auto of_kind = targets.find(kind);
  if (of_kind == targets.end()) return false;
  if (kind == CitationKind::section && key.find('.') == std::string::npos) {
    return std::any_of(of_kind->second.begin(), of_kind->second.end(),
                       [&](const auto& target) { return target.first.starts_with(key + "."); });
  }
  return of_kind->second.contains(key);
}

}  // namespace bw::book
