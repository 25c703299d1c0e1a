// Little-endian numbers and length-prefixed texts, as MCAP stores them. Reading cannot leave the bytes.
#pragma once

#include <concepts>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bw::bag {

using Bytes = std::vector<std::uint8_t>;
using BytesView = std::span<const std::uint8_t>;

class ByteWriter {
 public:
  explicit ByteWriter(Bytes& out) : out_(out) {}

  template <std::unsigned_integral T>
  void number(T value) {
    for (std::size_t i = 0; i < sizeof(T); ++i) out_.push_back(static_cast<std::uint8_t>(value >> (8U * i)));
  }
  void raw(BytesView bytes) { out_.insert(out_.end(), bytes.begin(), bytes.end()); }
  void raw(std::string_view text) { out_.insert(out_.end(), text.begin(), text.end()); }
  void text(std::string_view value) {
    number(static_cast<std::uint32_t>(value.size()));
    raw(value);
  }
  void map(const std::map<std::string, std::string>& entries) {
    const std::size_t start = begin_array();
    for (const auto& [key, value] : entries) {
      text(key);
      text(value);
    }
    end_array(start);
  }
  /// Arrays and maps are prefixed by their length in bytes.
  std::size_t begin_array() {
    number(std::uint32_t{0});
    return out_.size();
  }
  void end_array(std::size_t start) { overwrite(start - 4, static_cast<std::uint32_t>(out_.size() - start)); }
  template <std::unsigned_integral T>
  void overwrite(std::size_t at, T value) {
    for (std::size_t i = 0; i < sizeof(T); ++i) out_[at + i] = static_cast<std::uint8_t>(value >> (8U * i));
  }

 private:
  Bytes& out_;
};

class ByteReader {
 public:
  explicit ByteReader(BytesView bytes) : bytes_(bytes) {}

  [[nodiscard]] std::size_t offset() const { return offset_; }
  [[nodiscard]] std::size_t remaining() const { return bytes_.size() - offset_; }

  template <std::unsigned_integral T>
  [[nodiscard]] bool number(T& value) {
    if (remaining() < sizeof(T)) return false;
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) sum |= std::uint64_t{bytes_[offset_ + i]} << (8U * i);
    value = static_cast<T>(sum);
    offset_ += sizeof(T);
    return true;
  }
  [[nodiscard]] bool raw(std::uint64_t size, BytesView& view) {
    if (size > remaining()) return false;
    view = bytes_.subspan(offset_, static_cast<std::size_t>(size));
    offset_ += static_cast<std::size_t>(size);
    return true;
  }
  [[nodiscard]] bool text(std::string& value) {
    std::uint32_t size = 0;
    BytesView view;
    if (!number(size) || !raw(size, view)) return false;
    value.assign(view.begin(), view.end());
    return true;
  }
  /// The content of an array or map.
  [[nodiscard]] bool array(ByteReader& content) {
    std::uint32_t size = 0;
    BytesView view;
    if (!number(size) || !raw(size, view)) return false;
    content = ByteReader(view);
    return true;
  }
  [[nodiscard]] bool map(std::map<std::string, std::string>& entries) {
    ByteReader content({});
    if (!array(content)) return false;
    while (content.remaining() > 0) {
      std::string key;
      std::string value;
      if (!content.text(key) || !content.text(value)) return false;
      entries[std::move(key)] = std::move(value);
    }
    return true;
  }

 private:
  BytesView bytes_;
  std::size_t offset_ = 0;
};

}  // namespace bw::bag
