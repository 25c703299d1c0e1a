// One seed, many independent random streams: a noise that is switched on never shifts the draws of another.
#pragma once

#include <cstddef>
#include <cstdint>

#include "components/model/random.hpp"

namespace bw {

/// What a stream is for. The values are part of what a seed means: append, never renumber. `more_lasers` is
/// of the first of them, 7 of the second and so on: what comes new has a value far above.
enum class RandomPurpose : std::uint64_t {
  wheels = 1,
  laser = 2,
  imu = 3,
  gps = 4,
  walkers = 5,
  more_lasers = 6,
  orca_walkers = 1'000'000
};

/// The stream of `purpose` under `seed` (finaliser of SplitMix64 over both, so that near seeds share
/// nothing).
inline Random random_stream(std::uint64_t seed, RandomPurpose purpose) {
  std::uint64_t z = seed + static_cast<std::uint64_t>(purpose) * 0x9E3779B97F4A7C15ULL;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  return Random(z ^ (z >> 31));
}

/// The seed of the noises of one of several robots; the first has that of the world.
inline std::uint64_t robot_seed(std::uint64_t seed, std::size_t robot) {
  return seed + static_cast<std::uint64_t>(robot) * 0xD1B54A32D192ED03ULL;
}

}  // namespace bw
