// Particles here and there with weights that differ, for tests.
#pragma once

#include <numbers>

#include "components/localization/particle_filter/particle_set.hpp"
#include "components/model/random.hpp"

namespace bw::localization {

/// Positions normal with `spread` [m] about the origin, any heading.
inline ParticleSet random_set(std::size_t count, std::uint64_t seed, double spread) {
  Random random(seed);
  ParticleSet set;
  set.resize(count);
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    set.x[i] = spread * random.normal();
    set.y[i] = spread * random.normal();
    set.theta[i] = random.uniform(-std::numbers::pi, std::numbers::pi);
    sum += set.weight[i] = random.uniform();
  }
  for (double& w : set.weight) w /= sum;
  return set;
}

}  // namespace bw::localization
