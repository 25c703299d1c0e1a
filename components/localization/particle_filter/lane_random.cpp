#include "components/localization/particle_filter/lane_random.hpp"

#include <cmath>

#include "components/localization/particle_filter/vector_clones.hpp"
#include "components/localization/particle_filter/vector_math.hpp"

namespace bw::localization {
namespace {

constexpr std::size_t kLanes = LaneRandom::kLanes;
constexpr std::size_t kBlock = 2 * kLanes;  // each pair of draws gives two normals

std::uint64_t splitmix(std::uint64_t& state) {
  state += 0x9e3779b97f4a7c15ULL;
  std::uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

[[gnu::always_inline]] inline std::uint32_t rotated(std::uint32_t v, int by) {
  return (v << by) | (v >> (32 - by));
}

[[gnu::always_inline]] inline std::uint32_t next(std::array<LaneRandom::Lanes, 4>& s, std::size_t lane) {
  const std::uint32_t result = rotated(s[0][lane] + s[3][lane], 7) + s[0][lane];
  const std::uint32_t t = s[1][lane] << 9;
  s[2][lane] ^= s[0][lane];
  s[3][lane] ^= s[1][lane];
  s[1][lane] ^= s[2][lane];
  s[0][lane] ^= s[3][lane];
  s[2][lane] ^= t;
  s[3][lane] = rotated(s[3][lane], 11);
  return result;
}

// In (0, 1], so that the logarithm exists; steps of 2^-31 are finer than a float near 1 and coarse enough to
// convert as signed numbers, for which every CPU has an instruction.
[[gnu::always_inline]] inline float unit(std::uint32_t bits) {
  return (static_cast<float>(static_cast<std::int32_t>(bits >> 1)) + 1.0F) * 0x1.0p-31F;
}

BW_VECTOR_CLONES
void fill(std::array<LaneRandom::Lanes, 4>& state, float* out, std::size_t blocks) {
  std::array<LaneRandom::Lanes, 4> s = state;
  for (std::size_t b = 0; b < blocks; ++b, out += kBlock) {
    float first[kLanes];
    float second[kLanes];
    for (std::size_t i = 0; i < kLanes; ++i) first[i] = unit(next(s, i));
    for (std::size_t i = 0; i < kLanes; ++i) second[i] = unit(next(s, i));
    for (std::size_t i = 0; i < kLanes; ++i) {
      const float minus_log = -fast_log(first[i]);
      const float radius = std::sqrt(2.0F * (minus_log > 0.0F ? minus_log : 0.0F));
      const SinCos angle = sin_cos((second[i] - 0.5F) * (2.0F * std::numbers::pi_v<float>));
      out[i] = radius * angle.cos;
      out[kLanes + i] = radius * angle.sin;
    }
  }
  state = s;
}

}  // namespace

LaneRandom::LaneRandom(std::uint64_t seed) {
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    for (std::size_t word = 0; word < 4; word += 2) {
      const std::uint64_t bits = splitmix(seed);
      state_[word][lane] = static_cast<std::uint32_t>(bits);
      state_[word + 1][lane] = static_cast<std::uint32_t>(bits >> 32);
    }
  }
}

void LaneRandom::normals(std::vector<float>& values, std::size_t count) {
  const std::size_t blocks = (count + kBlock - 1) / kBlock;
  values.resize(blocks * kBlock);
  fill(state_, values.data(), blocks);
}

}  // namespace bw::localization
