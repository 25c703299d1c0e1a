// A file that is read in places. It is not trusted, and may be cut while it is read.
#pragma once

#include <cstdint>
#include <filesystem>

#include "runtime/recording/bag/bytes.hpp"

namespace bw::bag {

class ByteSource {
 public:
  /// Throws std::runtime_error naming the path: not there, not readable, no regular file.
  explicit ByteSource(std::filesystem::path path);
  ~ByteSource();
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  /// Replaces `out` by `size` bytes from `offset`; false when the file does not hold them all. Nothing is
  /// allocated for bytes that lie beyond the end of the file.
  [[nodiscard]] bool read(std::uint64_t offset, std::uint64_t size, Bytes& out) const;
  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace bw::bag
