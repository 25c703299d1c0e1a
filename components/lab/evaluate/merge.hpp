// Shards of one evaluation as the result that one run would have.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "components/lab/evaluate/suite_report.hpp"
#include "components/lab/shards/provenance.hpp"

namespace bw {

/// A file of `evaluate --json`.
struct ResultsFile {
  std::filesystem::path file;
  Provenance made;
  std::size_t planned = 0;
  std::vector<SuiteResult> results;

  std::size_t driven() const;
};

/// Throws std::runtime_error that names the file where it holds no drives, or is cut.
ResultsFile read_results_file(const std::filesystem::path& file);

/// All drives in the order in which one run drives them. Throws std::runtime_error where shards differ in what they were
/// made of, one is missing, there twice or not complete; it names the files.
std::vector<SuiteResult> merge(const std::vector<ResultsFile>& shards);

}  // namespace bw
