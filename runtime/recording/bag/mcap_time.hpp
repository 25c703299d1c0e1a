// Times as MCAP has them, unsigned nanoseconds, and as the rest of the program has them. What lies outside of
// the other's range is moved to its nearest end, so that times of a bag can always be subtracted from each
// other.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "runtime/base/time.hpp"

namespace bw::bag {

[[nodiscard]] inline std::uint64_t to_mcap_time(Time time) {
  return static_cast<std::uint64_t>(std::max<std::int64_t>(time.nanoseconds, 0));
}

[[nodiscard]] inline Time from_mcap_time(std::uint64_t nanoseconds) {
  constexpr auto kLast = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  return {static_cast<std::int64_t>(std::min(nanoseconds, kLast))};
}

}  // namespace bw::bag
