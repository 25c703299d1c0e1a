// Filters by name.
#pragma once

#include <cstdint>
#include <memory>

#include "components/localization/ekf/ekf_options.hpp"
#include "components/localization/localizer.hpp"
#include "components/localization/particle_filter/particle_filter_options.hpp"
#include "runtime/base/choice.hpp"

namespace bw::localization {

struct LocalizerOptions {
  EkfOptions ekf;
  ParticleFilterOptions particle_filter;

  template <class Visitor>
  void fields(Visitor& v) {
    v("ekf", ekf, {.doc = "extended Kalman filter"});
    v("particle_filter", particle_filter, {.doc = "Monte Carlo localization"});
  }
};

enum class Algorithm { ekf, particle_filter };
constexpr auto choice_table(Algorithm) {
  return choices<Algorithm>({{Algorithm::ekf, "ekf"}, {Algorithm::particle_filter, "particle_filter"}});
}

/// With room for so many sources.
std::unique_ptr<Localizer> make_localizer(Algorithm algorithm, const LocalizerOptions& options,
                                          std::uint64_t seed, int sources);

}  // namespace bw::localization
