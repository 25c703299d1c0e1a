// Sums of 32-bit counters of wheels, which wrap.
#pragma once

#include <cstdint>

namespace bw {

inline std::int32_t wrapping_sum(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}

/// From one reading to another, the short way round.
inline std::int32_t wrapping_difference(std::int32_t from, std::int32_t to) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(to) - static_cast<std::uint32_t>(from));
}

}  // namespace bw
