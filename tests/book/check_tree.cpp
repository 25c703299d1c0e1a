#include "tests/book/check_tree.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <tuple>

#include "tests/book/human_text.hpp"
#include "tests/book/targets.hpp"

namespace bw::book {
namespace {

namespace fs = std::filesystem;

struct Source {
  std::string file;
  Language language = Language::none;
  HumanText text;
};

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

bool is_left_out(const fs::path& folder, const fs::path& root, const std::vector<fs::path>& without) {
  const fs::path inside = fs::relative(folder, root);
  if (folder.filename().string().starts_with('.') && folder.filename() != ".ci") return true;
  if (inside == "build" || inside == "run" || fs::exists(folder / "CMakeCache.txt")) return true;
  return std::find(without.begin(), without.end(), inside) != without.end();
}

std::vector<fs::path> files_below(const fs::path& root, const std::vector<fs::path>& without) {
  std::vector<fs::path> files;
  for (auto entry = fs::recursive_directory_iterator(root); entry != fs::end(entry); ++entry) {
    if (entry->is_directory()) {
      if (is_left_out(entry->path(), root, without)) entry.disable_recursion_pending();
    } else if (entry->is_regular_file() && language_of(entry->path()) != Language::none) {
      files.push_back(entry->path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// One name against a pattern in which * stands for any characters.
bool matches(std::string_view name, std::string_view pattern) {
  if (pattern.empty()) return name.empty();
  if (pattern.front() != '*')
    return !name.empty() && name.front() == pattern.front() && matches(name.substr(1), pattern.substr(1));
  for (std::size_t skip = 0; skip <= name.size(); ++skip) {
    if (matches(name.substr(skip), pattern.substr(1))) return true;
  }
  return false;
}

bool path_exists(const fs::path& root, const std::string& path) {
  const std::size_t star = path.find('*');
  if (star == std::string::npos) return fs::exists(root / path);
  const fs::path folder = root / fs::path(path).parent_path();
  const std::string pattern = fs::path(path).filename();
  if (!fs::is_directory(folder) || folder.string().find('*') != std::string::npos) return false;
  return std::any_of(
      fs::directory_iterator(folder), fs::directory_iterator(),
      [&](const fs::directory_entry& e) { return matches(e.path().filename().string(), pattern); });
}

const char* name_of(CitationKind kind) {
  switch (kind) {
    case CitationKind::section:
      return "section";
    case CitationKind::equation:
      return "equation";
    case CitationKind::decision:
      return "decision";
    case CitationKind::experiment:
      return "experiment";
    case CitationKind::fault:
      return "row of faults";
    case CitationKind::table:
      return "table";
    case CitationKind::figure:
      return "figure";
    case CitationKind::algorithm:
      return "algorithm";
    case CitationKind::path:
      return "path";
    case CitationKind::link:
      return "link";
    case CitationKind::test:
      return "test";
    case CitationKind::forbidden:
      return "word";
  }
  return "citation";
}

class Checker {
 public:
  Checker(const fs::path& root, const std::vector<fs::path>& without) : root_(root) {
    for (const fs::path& path : files_below(root, without)) {
      Source source{fs::relative(path, root).generic_string(), language_of(path), {}};
      const std::string content = content_of(path);
      source.text = human_text(content, source.language);
      if (source.language == Language::markdown) book_.add_page(source.file, source.text);
      if (source.language == Language::cpp) book_.add_tests(source.file, content);
      sources_.push_back(std::move(source));
    }
  }

  TreeReport report() {
    report_.files = static_cast<int>(sources_.size());
    check_targets();
    check_index();
    for (const Source& source : sources_) check(source);
    std::sort(report_.complaints.begin(), report_.complaints.end(), [](const auto& a, const auto& b) {
      return std::tie(a.file, a.line, a.citation) < std::tie(b.file, b.line, b.citation);
    });
    return std::move(report_);
  }

 private:
  void complain(const std::string& file, int line, const std::string& citation, const std::string& why) {
    report_.complaints.push_back({file, line, citation, why});
  }

  // A number that two places claim points nowhere.
  void check_targets() {
    for (const auto& [kind, targets] : book_.targets) {
      if (kind == CitationKind::test) continue;
      for (const auto& [key, places] : targets) {
        for (std::size_t i = 1; i < places.size(); ++i) {
          complain(places[i].file, places[i].line, key,
                   std::string("this ") + name_of(kind) + " stands in " + places[0].file + " already");
        }
      }
    }
  }

  void check_index() {
    const Targets& sections = book_.targets[CitationKind::section];
    const fs::path folder = fs::path(kFrontPage).parent_path();
    for (const IndexEntry& entry : book_.index) {
      const auto section = sections.find(entry.section);
      if (section == sections.end()) {
        complain(std::string(kFrontPage), entry.line, entry.section,
                 "the index names a section that is not there");
      } else if ((folder / entry.page).lexically_normal() != fs::path(section->second[0].file)) {
        complain(std::string(kFrontPage), entry.line, entry.section,
                 "the index says " + entry.page + ", but it stands in " + section->second[0].file);
      }
    }
    for (const auto& [section, places] : sections) {
      const bool listed = std::any_of(book_.index.begin(), book_.index.end(),
                                      [&](const IndexEntry& entry) { return entry.section == section; });
      if (!listed) complain(places[0].file, places[0].line, section, "the index does not name this section");
    }
  }

  void check(const Source& source) {
    for (const Passage& passage : source.text.prose) {
      for (const Citation& citation : citations_in(passage.text)) check(source, passage, citation);
      if (source.language != Language::markdown) continue;
      for (const Citation& citation : markdown_citations_in(passage.text)) check(source, passage, citation);
      check_tests_of(source, passage);
    }
    for (const Passage& line : source.text.fenced) {
      for (const Citation& citation : paths_in(line.text)) check(source, line, citation);
    }
  }

  void check(const Source& source, const Passage& passage, const Citation& citation) {
    const std::string why = fault_of(source, citation);
    if (why.empty()) {
      ++report_.resolved[citation.kind];
    } else {
      complain(source.file, passage.line_at(citation.at), citation.key, why);
    }
  }

  std::string fault_of(const Source& source, const Citation& citation) const {
    switch (citation.kind) {
      case CitationKind::forbidden:
        return "names a text that is not in the tree: cite a section of the book";
      case CitationKind::path:
        return path_exists(root_, citation.key) ? "" : "there is no such file or folder";
      case CitationKind::link: {
        const fs::path folder = root_ / fs::path(source.file).parent_path();
        return fs::exists(folder / citation.key) ? "" : "the link leads nowhere";
      }
      default:
        break;
    }
    if (book_.holds(citation.kind, citation.key)) return "";
    return std::string("there is no such ") + name_of(citation.kind);
  }

  // Where a passage names source files of tests, its tests stand in them.
  void check_tests_of(const Source& source, const Passage& passage) {
    std::vector<std::string> files;
    for (const Citation& citation : citations_in(passage.text)) {
      if (citation.kind == CitationKind::path && citation.key.ends_with("_test.cpp"))
        files.push_back(citation.key);
    }
    if (files.empty()) return;
    const Targets& tests = book_.targets[CitationKind::test];
    for (const Citation& citation : markdown_citations_in(passage.text)) {
      const auto test = tests.find(citation.key);
      if (citation.kind != CitationKind::test || test == tests.end()) continue;
      const bool in_one = std::any_of(test->second.begin(), test->second.end(), [&](const Place& place) {
        return std::find(files.begin(), files.end(), place.file) != files.end();
      });
      if (!in_one)
        complain(source.file, passage.line_at(citation.at), citation.key,
                 "stands in " + test->second[0].file + ", which is not named beside it");
    }
  }

  fs::path root_;
  std::vector<Source> sources_;
  Book book_;
  TreeReport report_;
};

}  // namespace

std::string Complaint::text() const {
  return file + ":" + std::to_string(line) + ": " + citation + ": " + why;
}

int TreeReport::resolved_count() const {
  int count = 0;
  for (const auto& [kind, number] : resolved) count += number;
  return count;
}

TreeReport check_tree(const fs::path& root, const std::vector<fs::path>& without) {
  return Checker(root, without).report();
}

}  // namespace bw::book
