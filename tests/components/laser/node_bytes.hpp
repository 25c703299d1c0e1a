// Nodes as bytes, written from the protocol (components/laser/rplidar/nodes.hpp) for tests.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace bw::laser {

/// `degrees` clockwise, below 360; `range` [m], 0: nothing measured.
inline void append_node(std::vector<std::uint8_t>& bytes, double degrees, double range, bool starts = false,
                        int quality = 15) {
  const auto angle = static_cast<unsigned>(std::lround(degrees * 64.0)) << 1 | 1U;
  const auto distance = static_cast<unsigned>(std::lround(range * 4000.0));
  bytes.push_back(static_cast<std::uint8_t>(quality << 2 | (starts ? 1 : 2)));
  for (const unsigned word : {angle, distance}) {
    bytes.push_back(static_cast<std::uint8_t>(word & 0xFF));
    bytes.push_back(static_cast<std::uint8_t>(word >> 8));
  }
}

}  // namespace bw::laser
