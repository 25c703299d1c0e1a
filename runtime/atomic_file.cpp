#include "runtime/atomic_file.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <unistd.h>

namespace bw {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw std::runtime_error("cannot write " + path.string() + ": " + std::strerror(errno));
}

/// With the reason of the call before.
[[noreturn]] void fail_without(const std::filesystem::path& draft, const std::filesystem::path& path) {
  const int reason = errno;
  unlink(draft.c_str());
  errno = reason;
  fail(path);
}

void write_all(int descriptor, std::string_view content, const std::filesystem::path& path) {
  while (!content.empty()) {
    const ssize_t written = write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path);
    content.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace

void write_file_atomically(const std::filesystem::path& path, std::string_view content) {
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
  const std::filesystem::path draft = path.string() + ".part" + std::to_string(getpid());
  const int descriptor = open(draft.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) fail(path);
  try {
    write_all(descriptor, content, path);
    if (fsync(descriptor) != 0) fail(path);
  } catch (...) {
    close(descriptor);
    unlink(draft.c_str());
    throw;
  }
  close(descriptor);
  if (rename(draft.c_str(), path.c_str()) != 0) fail_without(draft, path);
}

}  // namespace bw
