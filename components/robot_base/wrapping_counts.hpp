// Sums of 32-bit counters of wheels, which wrap.
#pragma once

#include <cmath>
#include <cstdint>

namespace bw {

inline std::int32_t wrapping_sum(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}

/// From one reading to another, the short way round.
inline std::int32_t wrapping_difference(std::int32_t from, std::int32_t to) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(to) - static_cast<std::uint32_t>(from));
}

/// Between two readings, either way, without the sign: up to 2^31, which no std::int32_t holds.
inline double wrapping_distance(std::int32_t from, std::int32_t to) {
  return std::abs(static_cast<double>(wrapping_difference(from, to)));
}

}  // namespace bw
