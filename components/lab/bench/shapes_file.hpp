// Shapes of a made world as a table that the world reads (world.track_circles, world.track_walls); gone with this.
#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

#include <unistd.h>

namespace bw {

class ShapesFile {
 public:
  /// `name`: with the number of this process it is the file's, in the folder for temporary ones. Throws
  /// std::runtime_error.
  ShapesFile(const std::string& name, const std::string& rows)
      : path_(std::filesystem::temp_directory_path() / (name + "_" + std::to_string(getpid()) + ".csv")) {
    std::ofstream file(path_);
    file << rows;
    if (!file.flush()) throw std::runtime_error(path_.string() + ": cannot be written");
  }
  ~ShapesFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  ShapesFile(const ShapesFile&) = delete;
  ShapesFile& operator=(const ShapesFile&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace bw
