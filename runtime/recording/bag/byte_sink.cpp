#include "runtime/recording/bag/byte_sink.hpp"

#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace bw::bag {
namespace {

class FileSink final : public ByteSink {
 public:
  explicit FileSink(std::filesystem::path path)
      : path_(std::move(path)),
        descriptor_(open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600)) {
    if (descriptor_ < 0) fail();
  }
  ~FileSink() override { close(descriptor_); }
  FileSink(const FileSink&) = delete;
  FileSink& operator=(const FileSink&) = delete;

  void write(BytesView bytes) override {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail();
      size_ += static_cast<std::uint64_t>(written);
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
  }
  void sync() override {
    if (fdatasync(descriptor_) != 0) fail();
    if (!std::exchange(is_name_kept_, true)) keep_name();
  }
  std::uint64_t size() const override { return size_; }

 private:
  /// A file whose folder is not written is lost with the power, whatever was written into it.
  void keep_name() const {
    const std::filesystem::path folder = path_.has_parent_path() ? path_.parent_path() : ".";
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) fail();
    const bool is_kept = fsync(descriptor) == 0 || errno == EINVAL;  // some file systems cannot
    close(descriptor);
    if (!is_kept) fail();
  }
  [[noreturn]] void fail() const { throw std::system_error(errno, std::generic_category(), path_.string()); }

  std::filesystem::path path_;
  int descriptor_;
  std::atomic<std::uint64_t> size_ = 0;
  bool is_name_kept_ = false;
};

}  // namespace

std::unique_ptr<ByteSink> create_file(const std::filesystem::path& path) {
  return std::make_unique<FileSink>(path);
}

}  // namespace bw::bag
