// Particles as columns, so that loops over one of them vectorise.
#pragma once

#include <cstddef>
#include <vector>

namespace bw::localization {

/// Pose hypotheses X_MB with weights that sum to 1. All columns have the same length.
struct ParticleSet {
  std::vector<double> x;      ///< [m]
  std::vector<double> y;      ///< [m]
  std::vector<double> theta;  ///< [rad], wrapped
  std::vector<double> weight;

  std::size_t size() const { return x.size(); }
  void resize(std::size_t count) {
    x.resize(count);
    y.resize(count);
    theta.resize(count);
    weight.resize(count);
  }
};

}  // namespace bw::localization
