// A cursor over XCDR1 bytes that cannot leave them: every read says whether it succeeded, nothing is
// allocated.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

namespace bw {

class CdrReader {
 public:
  /// `cdr` begins with the encapsulation header; open() must succeed before anything is read.
  explicit CdrReader(std::span<const std::uint8_t> cdr) : bytes_(cdr) {}

  /// Accepts plain CDR, big or little endian (00 00 and 00 01; the two option bytes are free).
  [[nodiscard]] bool open() {
    if (bytes_.size() < 4 || bytes_[0] != 0 || bytes_[1] > 1) return false;
    swap_ = bytes_[1] == 0;
    bytes_ = bytes_.subspan(4);
    return true;
  }

  [[nodiscard]] std::size_t offset() const {
    return offset_;
  }  ///< from the first byte after the encapsulation

  template <class T>
  [[nodiscard]] bool read(T& value) {
    if (!align(sizeof(T)) || remaining() < sizeof(T)) return false;
    std::uint8_t raw[sizeof(T)];
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      raw[i] = bytes_[offset_ + (swap_ ? sizeof(T) - 1 - i : i)];
    }
    std::memcpy(&value, raw, sizeof(T));
    offset_ += sizeof(T);
    return true;
  }

  /// Length and characters without their NUL, which must be there. A length of 0 is what a null string of
  /// some writers becomes and reads as empty.
  [[nodiscard]] bool read(std::string_view& text) {
    std::uint32_t length = 0;
    if (!read(length) || length > remaining()) return false;
    text = {};
    if (length == 0) return true;
    if (bytes_[offset_ + length - 1] != 0) return false;
    text = {reinterpret_cast<const char*>(bytes_.data()) + offset_, length - 1};
    offset_ += length;
    return true;
  }

  /// Steps over `count` elements of `size` bytes, aligned to `size`, and gives their first byte.
  [[nodiscard]] bool skip(std::uint64_t count, std::uint32_t size, const std::uint8_t** first) {
    if (count == 0) return true;
    if (!align(size) || count > remaining() / size) return false;
    *first = bytes_.data() + offset_;
    offset_ += count * size;
    return true;
  }

 private:
  [[nodiscard]] std::size_t remaining() const { return bytes_.size() - offset_; }

  [[nodiscard]] bool align(std::size_t size) {
    const std::size_t padding = (size - offset_ % size) % size;
    if (padding > remaining()) return false;
    offset_ += padding;
    return true;
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t offset_ = 0;
  bool swap_ = false;
};

}  // namespace bw
