#include "components/local_planner/mppi/standard_normal.hpp"

#include <cmath>

namespace bw::mppi {
namespace {

// For 256 layers: where the tail begins, and the area of a layer (Marsaglia and Tsang 2000).
constexpr double kTail = 3.6541528853610088;
constexpr double kArea = 4.92867323399e-3;

double bell(double x) { return std::exp(-0.5 * x * x); }

}  // namespace

StandardNormal::StandardNormal(std::uint64_t seed) : random_(seed) {
  edge_[0] = kArea / bell(kTail);  // the lowest layer with the tail in it
  edge_[1] = kTail;
  for (std::size_t i = 2; i < kLayers; ++i)
    edge_[i] = std::sqrt(-2.0 * std::log(kArea / edge_[i - 1] + bell(edge_[i - 1])));
  edge_[kLayers] = 0.0;
  for (std::size_t i = 0; i < kLayers; ++i) inner_[i] = edge_[i + 1] / edge_[i];
}

inline double StandardNormal::draw_here() {
  for (;;) {
    const std::uint64_t bits = random_.bits();
    const std::size_t layer = bits & (kLayers - 1);
    // 53 bits that do not choose the layer, as a number in [-1, 1).
    const double share = static_cast<double>(static_cast<std::int64_t>(bits) >> 11) * 0x1.0p-52;
    if (std::abs(share) < inner_[layer]) return share * edge_[layer];
    if (layer == 0) return tail(share < 0.0);
    const double x = share * edge_[layer];
    const double low = std::exp(-0.5 * (edge_[layer] * edge_[layer] - x * x));
    const double high = std::exp(-0.5 * (edge_[layer + 1] * edge_[layer + 1] - x * x));
    if (high + random_.uniform() * (low - high) < 1.0) return x;
  }
}

double StandardNormal::draw() { return draw_here(); }

void StandardNormal::fill(double* first, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) first[i] = draw_here();
}

double StandardNormal::tail(bool negative) {
  double x = 0.0, y = 0.0;
  do {
    x = -std::log(1.0 - random_.uniform()) / kTail;
    y = -std::log(1.0 - random_.uniform());
  } while (2.0 * y < x * x);
  return negative ? -kTail - x : kTail + x;
}

}  // namespace bw::mppi
