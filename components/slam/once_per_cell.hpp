// Surfaces thinned to one a cell.
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_set>

#include "components/slam/surface_map.hpp"

namespace bw::slam {

class OncePerCell {
 public:
  explicit OncePerCell(double resolution) : resolution_(resolution) {}

  /// Whether it is the first one in its cell.
  bool take(const Surface& surface) {
    const auto index = [&](float at) {
      return static_cast<std::int64_t>(std::floor(static_cast<double>(at) / resolution_));
    };
    return taken_.insert(index(surface.x) * 1'000'003 + index(surface.y)).second;
  }

 private:
  double resolution_;  ///< [m]
  std::unordered_set<std::int64_t> taken_;
};

}  // namespace bw::slam
