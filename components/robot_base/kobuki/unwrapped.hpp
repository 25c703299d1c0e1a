// Counts and headings that wrap in 16 bits, gone on with in 32 bits and in radians.
#pragma once

#include <cstdint>
#include <numbers>
#include <optional>

namespace bw::kobuki {

/// A wheel encoder. A wrap takes 5.6 m; between two packets there are at most some centimetres.
class WheelCounter {
 public:
  /// How far it is to this one since the last one; 0 for the first.
  std::int32_t moved(std::uint16_t raw) const {
    return raw_ ? static_cast<std::int16_t>(static_cast<std::uint16_t>(raw - *raw_)) : 0;
  }
  void add(std::uint16_t raw) {
    count_ += static_cast<std::uint32_t>(moved(raw));
    raw_ = raw;
  }
  /// Goes on from this one; how far it is there is not known.
  void go_on_from(std::uint16_t raw) { raw_ = raw; }
  /// Since the first one; wraps as counters of 32 bits do.
  std::int32_t count() const { return static_cast<std::int32_t>(count_); }

 private:
  std::optional<std::uint16_t> raw_;
  std::uint32_t count_ = 0;
};

/// The board's heading, in hundredths of a degree between -180 and 180 from a zero of its own.
class Heading {
 public:
  /// [rad], counter-clockwise since the first one, unwrapped.
  double add(std::int16_t centidegrees) {
    constexpr int kRevolution = 36'000;
    int moved = before_ ? (centidegrees - *before_) % kRevolution : 0;
    if (moved > kRevolution / 2) moved -= kRevolution;
    if (moved < -kRevolution / 2) moved += kRevolution;
    before_ = centidegrees;
    sum_ += moved;
    return static_cast<double>(sum_) * std::numbers::pi / 18'000.0;
  }
  /// What the next one says of the rotation since the last one is not to be believed.
  void forget() { before_.reset(); }

 private:
  std::optional<std::int16_t> before_;
  std::int64_t sum_ = 0;
};

}  // namespace bw::kobuki
