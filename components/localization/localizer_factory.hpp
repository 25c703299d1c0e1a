// Filters by name.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "components/localization/ekf/ekf_options.hpp"
#include "components/localization/localizer.hpp"
#include "components/localization/particle_filter/particle_filter_options.hpp"

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

std::vector<std::string_view> localizer_names();

/// Throws std::invalid_argument for a name that localizer_names() does not hold.
std::unique_ptr<Localizer> make_localizer(const std::string& name, const LocalizerOptions& options,
                                          std::uint64_t seed);

}  // namespace bw::localization
