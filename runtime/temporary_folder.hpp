// A folder for as long as it is needed.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace bw {

class TemporaryFolder {
 public:
  /// Throws std::runtime_error.
  TemporaryFolder() {
    std::string path = (std::filesystem::temp_directory_path() / "bandwagon_XXXXXX").string();
    if (mkdtemp(path.data()) == nullptr) throw std::runtime_error(path + ": cannot be made");
    path_ = path;
  }
  ~TemporaryFolder() {
    std::error_code ignored;  // nothing more can be done about it
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace bw
