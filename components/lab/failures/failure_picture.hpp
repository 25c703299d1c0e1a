// How a drive failed, as one self-contained SVG: the seconds before the contact from above, in which way everybody went, until when the
// contact could have been avoided, and the motion that a search found from there (book 8.10).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "components/evaluation/judged_contact.hpp"
#include "components/evaluation/run_recorder.hpp"

namespace bw {

struct FailurePicture {
  std::string title;               ///< which drive
  std::vector<std::string> lines;  ///< what is to be said of it, below the title
  /// The contact that is shown; without one (a drive that was late) its end.
  std::optional<JudgedContact> contact = std::nullopt;
  double width = 1000.0;  ///< of the page [px]
};

/// Times in the picture are seconds since the drive began. `recording` needs a moment.
std::string failure_picture(const RunRecording& recording, const FailurePicture& picture);

}  // namespace bw
