// The counterpart of cdr_reader.hpp for messages whose class is not known: little-endian plain CDR with its
// encapsulation, padding zero, as runtime/wire/serialization.hpp writes it.
#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <vector>

namespace bw {

class CdrWriter {
 public:
  /// Replaces `bytes`.
  explicit CdrWriter(std::vector<std::uint8_t>& bytes) : bytes_(bytes) { bytes_ = {0, 1, 0, 0}; }

  template <class T>
  void write(T value) {
    static_assert(std::is_arithmetic_v<T>);
    bytes_.resize(kEncapsulation + (bytes_.size() - kEncapsulation + sizeof(T) - 1) / sizeof(T) * sizeof(T));
    const std::size_t at = bytes_.size();
    bytes_.resize(at + sizeof(T));
    std::memcpy(bytes_.data() + at, &value, sizeof(T));
  }

  /// Length with its NUL, characters, NUL.
  void write(std::string_view text) {
    write(static_cast<std::uint32_t>(text.size() + 1));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    bytes_.push_back(0);
  }

 private:
  static constexpr std::size_t kEncapsulation = 4;
  std::vector<std::uint8_t>& bytes_;
};

}  // namespace bw
