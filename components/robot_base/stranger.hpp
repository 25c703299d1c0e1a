// Who speaks on a cable where another device was expected, as far as the bytes show it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace bw {

/// Remembers the newest bytes that nobody understood.
class Stranger {
 public:
  void add(std::span<const std::uint8_t> bytes);
  void reset() { *this = {}; }
  std::uint64_t bytes() const { return count_; }
  /// For people: "as a Kobuki does (AA 55)"; what cannot be told is likely the wrong speed of the line.
  std::string likeness() const;

 private:
  std::array<std::uint8_t, 64> newest_{};
  std::uint64_t count_ = 0;
};

}  // namespace bw
