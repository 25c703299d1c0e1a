// How the client of an action makes up the id of a goal.
#pragma once

#include <algorithm>
#include <cstdint>

#include "runtime/ports.hpp"

namespace bw {

/// A random UUID (RFC 4122, version 4) of the bytes that `next_byte` gives.
template <class NextByte>
GoalId new_goal_id(NextByte next_byte) {
  GoalId id;
  std::ranges::generate(id, next_byte);
  id[6] = static_cast<std::uint8_t>((id[6] & 0x0FU) | 0x40U);
  id[8] = static_cast<std::uint8_t>((id[8] & 0x3FU) | 0x80U);
  return id;
}

}  // namespace bw
