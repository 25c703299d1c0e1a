// Every citation of a source tree, resolved or complained about.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/book/citations.hpp"

namespace bw::book {

struct Complaint {
  std::string file;  ///< relative to the root
  int line = 0;
  std::string citation;
  std::string why;

  std::string text() const;
};

struct TreeReport {
  std::vector<Complaint> complaints;  ///< by file and line
  std::map<CitationKind, int> resolved;
  int files = 0;

  int resolved_count() const;
};

/// Looks at all files below `root` that are written for people (language_of), whether or not a version
/// control knows them. Left out: hidden folders, folders that a build made, `build` and `run` at the top, and
/// the folders in `without` (relative to the root).
TreeReport check_tree(const std::filesystem::path& root, const std::vector<std::filesystem::path>& without);

}  // namespace bw::book
