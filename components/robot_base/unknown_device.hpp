// Who speaks on a cable where another device was expected, as far as the bytes show it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace bw {

/// Of all bytes since the last reset(). What it says changes seldom, so that people can read it.
class UnknownDevice {
 public:
  void add(std::span<const std::uint8_t> bytes);
  void reset() { *this = {}; }
  bool is_heard() const { return is_heard_; }
  /// For people: "it speaks as a Kobuki does (AA 55)"; what cannot be told is likely the wrong speed of the
  /// line.
  std::string likeness() const;

 private:
  bool is_heard_ = false, is_text_ = true;
  int kobuki_headers_ = 0, rplidar_headers_ = 0, error_words_ = 0;
  std::array<char, 5> newest_{};  ///< the last one last
};

}  // namespace bw
