#include "components/localization/health.hpp"

namespace bw::localization {

std::string_view to_string(HealthCause cause) {
  switch (cause) {
    case HealthCause::no_position:
      return "waits for positions that agree";
    case HealthCause::no_heading:
      return "waits for a compass or a way driven";
    case HealthCause::uncertain_position:
      return "position uncertain";
    case HealthCause::uncertain_heading:
      return "heading uncertain";
    case HealthCause::contradicted:
      return "every position contradicts the estimate";
    case HealthCause::wheels_silent:
      return "wheels silent";
    case HealthCause::source_silent:
      return "source silent";
    case HealthCause::source_rejected:
      return "source rejected";
    case HealthCause::slipping:
      return "wheels slip";
    case HealthCause::gyro_in_doubt:
      return "gyro and wheels disagree";
    case HealthCause::estimate_reset:
      return "estimate reset";
    case HealthCause::clock_jump:
      return "clock jumped";
    case HealthCause::no_map:
      return "no map for the laser";
    case HealthCause::scan_mismatch:
      return "the scan does not fit the map";
    case HealthCause::searching:
      return "searches the whole map";
    case HealthCause::several_places:
      return "several places fit";
  }
  return "unknown";
}

}  // namespace bw::localization
