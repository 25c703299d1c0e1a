// Many random numbers at a time: 16 xoshiro128++ generators (Blackman and Vigna, "Scrambled linear
// pseudorandom number generators", 2021) side by side, seeded by splitmix64; normal draws by Box and Muller.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bw::localization {

class LaneRandom {
 public:
  explicit LaneRandom(std::uint64_t seed);

  /// `values` becomes at least `count` standard normal draws (more when count is not a multiple of 32), none
  /// beyond 6.7.
  void normals(std::vector<float>& values, std::size_t count);

  static constexpr std::size_t kLanes = 16;
  using Lanes = std::array<std::uint32_t, kLanes>;

 private:
  std::array<Lanes, 4> state_;
};

}  // namespace bw::localization
