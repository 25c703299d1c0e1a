#include "components/localization/localizer_factory.hpp"

#include "components/localization/ekf/ekf.hpp"
#include "components/localization/particle_filter/particle_filter.hpp"

namespace bw::localization {

std::unique_ptr<Localizer> make_localizer(Algorithm algorithm, const LocalizerOptions& options,
                                          std::uint64_t seed, int sources) {
  if (algorithm == Algorithm::ekf) return std::make_unique<Ekf>(options.ekf, sources);
  return std::make_unique<ParticleFilter>(options.particle_filter, seed, sources);
}

}  // namespace bw::localization
