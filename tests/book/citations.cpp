#include "tests/book/citations.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

namespace bw::book {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }

constexpr std::array<std::string_view, 8> kRooms = {"components/",     "config/", "runtime/", "tests/",
                                                    "launch_scripts/", "idl/",    "cmake/",   ".ci/"};

// Texts outside of the tree, by words that name them.
constexpr std::array<std::string_view, 8> kOutside = {"DESIGN.md",     "_anchors.md",  "planning_anchors",
                                                      "battery row",   "battery, row", "dissertation_spec",
                                                      "scenes/README", "ros2_interop"};

constexpr std::array<std::string_view, 6> kSeparators = {", and ", ", ", " and ", " to ", " or ", "–"};

/// A cursor over the text.
struct Scan {
  std::string_view text;
  std::size_t at = 0;

  char operator[](std::size_t offset) const { return at + offset < text.size() ? text[at + offset] : '\0'; }
  char before() const { return at > 0 ? text[at - 1] : '\0'; }
  bool begins_word() const { return !is_word(before()); }
  bool eat(std::string_view token) {
    if (text.substr(at, token.size()) != token) return false;
    at += token.size();
    return true;
  }
  /// Digits; not part of a longer word.
  std::optional<std::string> integer() {
    std::size_t n = 0;
    while (is_digit((*this)[n])) ++n;
    if (n == 0 || is_word((*this)[n]) || ((*this)[n] == '.' && is_digit((*this)[n + 1]))) return {};
    const std::string number(text.substr(at, n));
    at += n;
    return number;
  }
  /// Digits, dot, one or two digits; with `lettered` a small letter may follow and is left out.
  std::optional<std::string> dotted(bool lettered = false) {
    std::size_t n = 0;
    while (is_digit((*this)[n])) ++n;
    if (n == 0 || (*this)[n] != '.') return {};
    std::size_t end = n + 1;
    while (is_digit((*this)[end])) ++end;
    if (end == n + 1 || end > n + 3) return {};
    std::size_t after = end;
    if (lettered && std::islower(static_cast<unsigned char>((*this)[after])) != 0) ++after;
    if (is_word((*this)[after]) || ((*this)[after] == '.' && is_digit((*this)[after + 1]))) return {};
    const std::string number(text.substr(at, end));
    at += after;
    return number;
  }
};

using Reader = std::optional<std::string> (*)(Scan&);

std::optional<std::string> read_integer(Scan& scan) { return scan.integer(); }
std::optional<std::string> read_dotted(Scan& scan) { return scan.dotted(); }
std::optional<std::string> read_lettered(Scan& scan) { return scan.dotted(true); }
std::optional<std::string> read_section(Scan& scan) {
  if (auto number = scan.dotted()) return number;
  return scan.integer();
}

struct Keyword {
  std::string_view word;  ///< with the space behind it
  CitationKind kind;
  Reader first;
  Reader next;  ///< of a list that goes on; null: one only
};

constexpr std::array kKeywords = {
    Keyword{"book ", CitationKind::section, read_section, read_dotted},
    Keyword{"Book ", CitationKind::section, read_section, read_dotted},
    Keyword{"equation ", CitationKind::equation, read_dotted, nullptr},
    Keyword{"equations ", CitationKind::equation, read_dotted, read_dotted},
    Keyword{"row ", CitationKind::fault, read_integer, nullptr},
    Keyword{"rows ", CitationKind::fault, read_integer, read_integer},
    Keyword{"Table ", CitationKind::table, read_dotted, nullptr},
    Keyword{"Tables ", CitationKind::table, read_dotted, read_dotted},
    Keyword{"Figure ", CitationKind::figure, read_lettered, nullptr},
    Keyword{"Figures ", CitationKind::figure, read_lettered, read_lettered},
    Keyword{"Algorithm ", CitationKind::algorithm, read_integer, nullptr},
    Keyword{"Algorithms ", CitationKind::algorithm, read_integer, read_integer},
};

void find_keyword(Scan scan, std::vector<Citation>& found) {
  if (!scan.begins_word()) return;
  for (const Keyword& keyword : kKeywords) {
    Scan ahead = scan;
    if (!ahead.eat(keyword.word)) continue;
    auto number = keyword.first(ahead);
    while (number) {
      found.push_back({keyword.kind, *number, scan.at});
      number.reset();
      if (keyword.next == nullptr) break;
      for (const std::string_view separator : kSeparators) {
        Scan further = ahead;
        if (!further.eat(separator)) continue;
        number = keyword.next(further);
        if (number) ahead = further;
        break;
      }
    }
  }
}

void find_equation(const Scan& scan, std::vector<Citation>& found) {
  if (scan[0] != '(' || is_word(scan.before()) || scan.before() == ']' || scan.before() == '>') return;
  Scan ahead = scan;
  ++ahead.at;
  const auto number = ahead.dotted();
  if (!number || ahead[0] != ')' || (*number)[1] != '.' || (*number)[0] < '1' || (*number)[0] > '3') return;
  found.push_back({CitationKind::equation, *number, scan.at});
}

void find_label(const Scan& scan, std::vector<Citation>& found) {
  if (!scan.begins_word() || scan.before() == '-' || (scan[0] != 'D' && scan[0] != 'E') || scan[1] < '1' ||
      scan[1] > '9')
    return;
  const bool decision = scan[0] == 'D';
  const std::size_t end = decision && is_digit(scan[2]) ? 3 : 2;
  if (is_word(scan[end])) return;
  found.push_back({decision ? CitationKind::decision : CitationKind::experiment,
                   std::string(scan.text.substr(scan.at, end)), scan.at});
}

void find_outside(const Scan& scan, std::vector<Citation>& found) {
  const auto forbid = [&](std::size_t length) {
    found.push_back({CitationKind::forbidden, std::string(scan.text.substr(scan.at, length)), scan.at});
  };
  for (const std::string_view words : kOutside) {
    if (scan.text.substr(scan.at, words.size()) == words) forbid(words.size());
  }
  if (!scan.begins_word()) return;
  for (const std::string_view word : {std::string_view("spec"), std::string_view("Spec")}) {
    Scan ahead = scan;
    if (ahead.eat(word) && !is_word(ahead[0]) && ahead[0] != '.') forbid(word.size());
  }
  for (const std::string_view word : {std::string_view("anchors "), std::string_view("Anchors ")}) {
    Scan ahead = scan;
    if (!ahead.eat(word)) continue;
    ahead.eat("(");
    if (ahead.dotted()) forbid(ahead.at - scan.at);
  }
}

void find_path(const Scan& scan, std::vector<Citation>& found) {
  const char before = scan.before();
  if (is_word(before) || before == '/' || before == '.' || before == '-' || before == '}') return;
  for (const std::string_view room : kRooms) {
    if (scan.text.substr(scan.at, room.size()) != room) continue;
    std::size_t length = room.size();
    while (is_word(scan[length]) ||
           (scan[length] != '\0' && std::string_view("./*+-").find(scan[length]) != std::string_view::npos))
      ++length;
    std::string path(scan.text.substr(scan.at, length));
    while (path.ends_with('.') || path.ends_with('-') || path.ends_with('+')) path.pop_back();
    found.push_back({CitationKind::path, path, scan.at});
  }
}

void find_link(const Scan& scan, std::vector<Citation>& found) {
  if (scan[0] != ']' || scan[1] != '(') return;
  const std::size_t end = scan.text.find(')', scan.at);
  if (end == std::string_view::npos) return;
  std::string target(scan.text.substr(scan.at + 2, end - scan.at - 2));
  if (target.find("://") != std::string::npos) return;
  target = target.substr(0, target.find('#'));
  if (!target.empty()) found.push_back({CitationKind::link, target, scan.at});
}

// `Suite.Name`, both with a capital: how a test is named.
void find_test(const Scan& scan, std::vector<Citation>& found) {
  if (scan[0] != '`' || !is_upper(scan[1])) return;
  std::size_t end = 1;
  std::size_t dots = 0;
  for (; is_word(scan[end]) || (scan[end] == '.' && is_upper(scan[end + 1])); ++end) {
    if (scan[end] == '.') ++dots;
  }
  if (dots != 1 || scan[end] != '`') return;
  found.push_back({CitationKind::test, std::string(scan.text.substr(scan.at + 1, end - 1)), scan.at});
}

using Finder = void (*)(const Scan& scan, std::vector<Citation>& found);

std::vector<Citation> found_by(std::initializer_list<Finder> finders, std::string_view text) {
  std::vector<Citation> found;
  for (Scan scan{text}; scan.at < text.size(); ++scan.at) {
    for (const Finder find : finders) find(scan, found);
  }
  return found;
}

void find_words(const Scan& scan, std::vector<Citation>& found) { find_keyword(scan, found); }

}  // namespace

std::vector<Citation> citations_in(std::string_view text) {
  return found_by({find_words, find_equation, find_label, find_outside, find_path}, text);
}

std::vector<Citation> markdown_citations_in(std::string_view text) {
  return found_by({find_link, find_test}, text);
}

std::vector<Citation> paths_in(std::string_view text) { return found_by({find_path}, text); }

}  // namespace bw::book
