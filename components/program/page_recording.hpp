// `--html`: a drive recorded aside, and made into one page when it is over (components/program/drive_page).
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "components/program/recording.hpp"
#include "runtime/temporary_folder.hpp"

namespace bw {

class PageRecording {
 public:
  /// When the graph is known to be sound. In lock-step the run waits for the disk (`waits`). Throws
  /// std::runtime_error or std::system_error.
  [[nodiscard]] std::shared_ptr<SampleTap> open(bool waits, const bag::BagDescription& description);
  /// Writes the page. Why there is none, or what is not on it; empty: all is.
  [[nodiscard]] std::string finish(const Host& host, const std::string& name,
                                   const std::filesystem::path& html);

 private:
  TemporaryFolder folder_;
  Recording recording_;
};

}  // namespace bw
