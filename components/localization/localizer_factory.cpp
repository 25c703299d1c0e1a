#include "components/localization/localizer_factory.hpp"

#include <stdexcept>

#include "components/localization/ekf/ekf.hpp"
#include "components/localization/particle_filter/particle_filter.hpp"

namespace bw::localization {

std::vector<std::string_view> localizer_names() { return {"ekf", "particle_filter"}; }

std::unique_ptr<Localizer> make_localizer(const std::string& name, const LocalizerOptions& options,
                                          std::uint64_t seed) {
  if (name == "ekf") return std::make_unique<Ekf>(options.ekf);
  if (name == "particle_filter") return std::make_unique<ParticleFilter>(options.particle_filter, seed);
  throw std::invalid_argument("no localization called '" + name + "'");
}

}  // namespace bw::localization
