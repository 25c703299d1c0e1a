// Byte streams that are damaged at random, for tests of parsers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <random>

#include "tests/components/robot_base/scripted_link.hpp"

namespace bw {

/// How many streams: BANDWAGON_SERIAL_FUZZ, else 20,000.
inline int fuzz_streams() {
  const char* wanted = std::getenv("BANDWAGON_SERIAL_FUZZ");
  return wanted == nullptr ? 20'000 : std::max(1, std::atoi(wanted));
}

using Random = std::mt19937;
inline std::size_t below(Random& random, std::size_t bound) {
  return std::uniform_int_distribution<std::size_t>(0, bound - 1)(random);
}

inline Bytes noise(Random& random, std::size_t size) {
  Bytes bytes(size);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(below(random, 256));
  return bytes;
}

/// Flips, losses, insertions, repetitions, noise.
inline void damage(Random& random, Bytes& bytes) {
  for (std::size_t changes = 1 + below(random, 6); changes > 0 && !bytes.empty(); --changes) {
    const auto at = static_cast<std::ptrdiff_t>(below(random, bytes.size()));
    const auto length = static_cast<std::ptrdiff_t>(1 + below(random, 12));
    const auto end = std::min<std::ptrdiff_t>(at + length, static_cast<std::ptrdiff_t>(bytes.size()));
    const Bytes part(bytes.begin() + at, bytes.begin() + end);
    switch (below(random, 5)) {
      case 0:
        bytes[static_cast<std::size_t>(at)] ^= static_cast<std::uint8_t>(1U << below(random, 8));
        break;
      case 1:
        bytes.erase(bytes.begin() + at, bytes.begin() + end);
        break;
      case 2:
        bytes.insert(bytes.begin() + at, part.begin(), part.end());
        break;
      case 3:
        bytes.resize(static_cast<std::size_t>(at));
        break;
      default: {
        const Bytes strange = noise(random, part.size());
        bytes.insert(bytes.begin() + at, strange.begin(), strange.end());
      }
    }
  }
}

}  // namespace bw
