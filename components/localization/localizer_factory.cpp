#include "components/localization/localizer_factory.hpp"

#include <stdexcept>

#include "components/localization/ekf/ekf.hpp"

namespace bw::localization {

std::vector<std::string_view> localizer_names() { return {"ekf"}; }

std::unique_ptr<Localizer> make_localizer(const std::string& name, const LocalizerOptions& options,
                                          std::uint64_t) {
  if (name == "ekf") return std::make_unique<Ekf>(options.ekf);
  throw std::invalid_argument("no localization called '" + name + "'");
}

}  // namespace bw::localization
