// What the cells of a costmap say, in the numbers of Nav2's.
#pragma once

#include <cstdint>

namespace bw {

inline constexpr std::uint8_t kFreeCost = 0;
inline constexpr std::uint8_t kInscribedCost = 253;  ///< the robot's inscribed disc would touch an obstacle
inline constexpr std::uint8_t kLethalCost = 254;
inline constexpr std::uint8_t kUnknownCost = 255;

}  // namespace bw
