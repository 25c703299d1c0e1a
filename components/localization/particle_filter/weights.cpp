#include "components/localization/particle_filter/weights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "components/localization/particle_filter/vector_clones.hpp"
#include "components/localization/particle_filter/vector_math.hpp"

namespace bw::localization {
namespace {

BW_VECTOR_CLONES
void multiply_by_exp(double* __restrict weight, const double* __restrict log_weight, std::size_t count,
                     double largest) {
  for (std::size_t i = 0; i < count; ++i) {
    const double below = log_weight[i] - largest;
    // False for NaN: such a particle gets no weight.
    const float exponent = below <= 0.0 ? static_cast<float>(below) : -1e9F;
    weight[i] *= static_cast<double>(fast_exp(exponent));
  }
}

}  // namespace

bool reweigh(std::vector<double>& weight, std::span<const double> log_weight) {
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < weight.size(); ++i) {
    if (weight[i] > 0.0 && log_weight[i] > largest) largest = log_weight[i];
  }
  if (!std::isfinite(largest)) return false;
  multiply_by_exp(weight.data(), log_weight.data(), weight.size(), largest);
  double sum = 0.0;
  for (const double w : weight) sum += w;  // at least the weight of the best one
  for (double& w : weight) w /= sum;
  return true;
}

double effective_size(std::span<const double> weight) {
  double squares = 0.0;
  for (const double w : weight) squares += w * w;
  return squares > 0.0 ? 1.0 / squares : 0.0;
}

void systematic_draw(std::span<const double> weight, std::size_t count, double u,
                     std::vector<std::size_t>& which) {
  which.resize(count);
  if (weight.empty()) return;
  const double n = static_cast<double>(count);
  double sum = n * weight[0];
  std::size_t i = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double point = u + static_cast<double>(k);
    while (sum <= point && i + 1 < weight.size()) sum += n * weight[++i];
    which[k] = i;
  }
  // Rounding of the sum may run past the last particle with a weight.
  for (std::size_t k = count; k-- > 0 && !(weight[which[k]] > 0.0) && which[k] > 0;) {
    std::size_t last = which[k];
    while (last > 0 && !(weight[last] > 0.0)) --last;
    which[k] = last;
  }
}

void take(const ParticleSet& particles, std::span<const std::size_t> which, ParticleSet& result) {
  result.resize(which.size());
  const double weight = 1.0 / static_cast<double>(which.size());
  for (std::size_t k = 0; k < which.size(); ++k) {
    const std::size_t i = which[k];
    result.x[k] = particles.x[i];
    result.y[k] = particles.y[i];
    result.theta[k] = particles.theta[i];
    result.weight[k] = weight;
  }
}

double kld_bound(double bins, double error, double z) {
  if (bins <= 1.0) return 0.0;
  const double c = 2.0 / (9.0 * (bins - 1.0));
  const double root = 1.0 - c + std::sqrt(c) * z;
  return (bins - 1.0) / (2.0 * error) * root * root * root;
}

}  // namespace bw::localization
