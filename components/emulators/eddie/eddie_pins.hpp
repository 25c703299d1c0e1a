// Digital pins of an Eddie board, as masks of pins 0 to 18.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace bw::emulators {

class EddiePins {
 public:
  /// IN, OUT, LOW, HIGH, SGP, SPNG; false: none of these.
  bool set(std::string_view command, std::uint32_t mask) {
    if (command == "IN") {
      outputs_ &= ~mask;
    } else if (command == "OUT") {
      outputs_ |= mask;
    } else if (command == "LOW") {
      high_ &= ~mask;
    } else if (command == "HIGH") {
      high_ |= mask;
    } else if (command == "SPNG") {
      sonars_ = mask;
    } else if (command == "SGP") {
      sonars_ &= ~mask;
    } else {
      return false;
    }
    return true;
  }
  /// INS, OUTS, LOWS, HIGHS, READ; nothing: none of these.
  std::optional<std::uint32_t> get(std::string_view command) const {
    if (command == "INS") return kAll & ~outputs_;
    if (command == "OUTS") return outputs_;
    if (command == "LOWS") return kAll & ~high_;
    if (command == "HIGHS") return high_;
    if (command == "READ") return outputs_ & high_;  // nothing is wired to the inputs
    return std::nullopt;
  }
  std::uint32_t sonars() const { return sonars_; }

 private:
  static constexpr std::uint32_t kAll = 0x7FFFF;

  std::uint32_t outputs_ = 0, high_ = 0;
  std::uint32_t sonars_ = 3;
};

}  // namespace bw::emulators
