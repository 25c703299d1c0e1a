#include "runtime/atomic_file.hpp"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

namespace bw {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw std::runtime_error("cannot write " + path.string() + ": " + std::strerror(errno));
}

void write_all(int descriptor, std::string_view content, const std::filesystem::path& path) {
  while (!content.empty()) {
    const ssize_t written = write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path);
    content.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// A new file beside `path`, whose name nobody can have taken before: in a folder that others write, a link
/// would lead elsewhere.
class Draft {
 public:
  explicit Draft(const std::filesystem::path& path) : path_(path) {
    std::uint64_t random = 0;
    if (getrandom(&random, sizeof random, 0) != static_cast<ssize_t>(sizeof random)) fail(path_);
    name_ = path.string() + ".part" + std::to_string(random);
    descriptor_ = open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644);
    if (descriptor_ < 0) fail(path_);
  }
  ~Draft() {
    close(descriptor_);
    if (!is_named_) unlink(name_.c_str());
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  void write(std::string_view content) {
    struct stat before = {};
    const bool replaces = lstat(path_.c_str(), &before) == 0 && S_ISREG(before.st_mode);
    if (replaces && fchmod(descriptor_, before.st_mode & 0777) != 0) fail(path_);
    write_all(descriptor_, content, path_);
    if (fsync(descriptor_) != 0) fail(path_);
  }
  void take_name() {
    if (rename(name_.c_str(), path_.c_str()) != 0) fail(path_);
    is_named_ = true;
    const std::filesystem::path folder = path_.has_parent_path() ? path_.parent_path() : ".";
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;  // a folder that may be written but not read
    fsync(descriptor);           // some file systems cannot
    close(descriptor);
  }

 private:
  const std::filesystem::path& path_;
  std::string name_;
  int descriptor_ = -1;
  bool is_named_ = false;
};

}  // namespace

void write_file_atomically(const std::filesystem::path& path, std::string_view content) {
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
  Draft draft(path);
  draft.write(content);
  draft.take_name();
}

}  // namespace bw
