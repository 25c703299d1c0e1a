// Many standard normal numbers, quickly, and the same with every compiler and library.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "components/model/random.hpp"

namespace bw::mppi {

/// The ziggurat of Marsaglia and Tsang 2000 in the form of Doornik 2005: 256 layers of equal area under the
/// bell, of which one draw of 64 bits chooses the layer and the position within; one draw in a hundred needs
/// more.
class StandardNormal {
 public:
  explicit StandardNormal(std::uint64_t seed);

  double draw();
  void fill(double* first, std::size_t count);

 private:
  double draw_here();  // inlined where many are drawn
  double tail(bool negative);

  static constexpr int kLayers = 256;
  Random random_;
  std::array<double, kLayers + 1> edge_;  ///< right edges of the layers, from the lowest
  std::array<double, kLayers> inner_;     ///< share of a layer's width that lies under the bell
};

}  // namespace bw::mppi
