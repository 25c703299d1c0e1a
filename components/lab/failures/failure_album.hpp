// One report of the drives that failed: a list with verdicts and causes, then a picture of each
// (possible/theory.md 8.10).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "components/evaluation/judged_contact.hpp"
#include "components/evaluation/run_recorder.hpp"
#include "components/lab/failures/failure_cause.hpp"
#include "components/lab/report/document.hpp"

namespace bw {

struct FailedDrive {
  std::string title;     ///< which drive, with its seed
  std::string outcome;   ///< one line: how it ended
  bool reached = false;  ///< the goal
  std::vector<JudgedContact> contacts;
};

/// The contact that made the drive fail, the first; nothing without any.
std::optional<JudgedContact> deciding_contact(const FailedDrive& drive);

/// A drive with what was found about it.
struct ExplainedFailure {
  FailedDrive drive;
  FoundCause cause;
  report::Chart picture = {};
};

class FailureAlbum {
 public:
  /// `most`: of further drives there are no pictures.
  FailureAlbum(std::filesystem::path folder, report::Writer write, int most = 30)
      : folder_(std::move(folder)), write_(std::move(write)), most_(most) {}

  bool is_full() const { return static_cast<int>(failures_.size()) >= most_; }

  /// Writes index.html anew. Throws std::runtime_error when it cannot. `recording` needs a moment.
  void add(const FailedDrive& drive, const RunRecording& recording);

 private:
  std::filesystem::path folder_;
  report::Writer write_;
  int most_;
  std::vector<ExplainedFailure> failures_;
};

/// How many failed for which cause: "3 turning_walker, 1 stuck"; "none".
std::string causes_in_words(const std::vector<ExplainedFailure>& failures);

/// A list, a row for each, and a picture with all of its words for each.
report::Document failures_report(const std::vector<ExplainedFailure>& failures);

}  // namespace bw
