// A seed for each name, so that the random numbers of one thing do not depend on its neighbours.
#pragma once

#include <cstdint>
#include <string_view>

namespace bw {

/// FNV-1a of the name, from its offset basis and `seed`.
inline std::uint64_t named_seed(std::string_view name, std::uint64_t seed) {
  std::uint64_t hash = 14695981039346656037ULL ^ seed;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return hash;
}

}  // namespace bw
