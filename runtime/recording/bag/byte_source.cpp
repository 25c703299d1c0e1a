#include "runtime/recording/bag/byte_source.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace bw::bag {
namespace {

constexpr std::uint64_t kLargeRead = std::uint64_t{128} << 10;  // what Linux reads ahead by itself [bytes]

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& why) {
  throw std::runtime_error("cannot read " + path.string() + ": " + why);
}

}  // namespace

ByteSource::ByteSource(std::filesystem::path path) : path_(std::move(path)) {
  // Without O_NONBLOCK a named pipe would hold us until somebody writes to it.
  descriptor_ = open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor_ < 0) fail(path_, std::strerror(errno));
  struct stat status {};
  if (fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) {
    close(descriptor_);
    fail(path_, S_ISDIR(status.st_mode) ? "it is a folder" : "it is no regular file");
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
}

ByteSource::~ByteSource() { close(descriptor_); }

bool ByteSource::read(std::uint64_t offset, std::uint64_t size, Bytes& out) const {
  if (offset > size_ || size > size_ - offset) return false;
  // In one request: read() alone would ask the disk for one piece after the other.
  if (size > kLargeRead) {
    static_cast<void>(posix_fadvise(descriptor_, static_cast<off_t>(offset), static_cast<off_t>(size),
                                    POSIX_FADV_WILLNEED));
  }
  out.resize(static_cast<std::size_t>(size));
  std::size_t done = 0;
  while (done < out.size()) {
    const ssize_t got =
        pread(descriptor_, out.data() + done, out.size() - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    done += static_cast<std::size_t>(got);
  }
  return true;
}

}  // namespace bw::bag
