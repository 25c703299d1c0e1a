// Who makes one page of a recorded drive: the runtime knows no page, so the program says it.
#pragma once

#include <filesystem>
#include <string>

namespace bw::cli {

struct PageWriter {
  /// Throws std::runtime_error that names `option` where the program has no page.
  void (*require)(const std::string& option);
  /// `bag`: a file or a folder. Throws std::runtime_error with the reason.
  void (*write)(const std::filesystem::path& bag, const std::string& name, const std::filesystem::path& html);
};

/// Once, before verbs run.
void set_page_writer(const PageWriter& writer);

/// Throws std::runtime_error where nobody was set.
const PageWriter& page_writer();

}  // namespace bw::cli
