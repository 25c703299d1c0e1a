// What a component knows and the one in its place shall know, when its process is killed and started again: a small
// file in $RUNTIME_DIRECTORY, which `bandwagon launch` and systemd (RuntimeDirectoryPreserve=restart) keep for a restart
// and for nothing else. A process that is started by hand finds nothing, and leaves nothing.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace bw {

class Keepsake {
 public:
  /// Keeps nothing.
  Keepsake() = default;
  /// `is_first`: of this process; one that is configured anew finds nothing.
  Keepsake(std::filesystem::path file, bool is_first) : file_(std::move(file)) {
    if (std::ifstream in(file_, std::ios::binary); is_first && in)
      left_.assign(std::istreambuf_iterator<char>(in), {});
  }

  /// By the process before this one; empty: nothing. To be read without trust.
  [[nodiscard]] const std::string& left() const { return left_; }
  /// Whole or not at all, and not synced: it outlives the process, not the machine. What cannot be written is not kept.
  void keep(std::string_view text) const {
    if (file_.empty()) return;
    const std::filesystem::path next = file_.string() + ".new";
    std::error_code ignored;
    std::filesystem::create_directories(file_.parent_path(), ignored);
    if ((std::ofstream(next, std::ios::binary | std::ios::trunc) << text).flush())
      std::filesystem::rename(next, file_, ignored);
  }

 private:
  std::filesystem::path file_;
  std::string left_;
};

}  // namespace bw
