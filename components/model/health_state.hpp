// How far a pose can be trusted: the same words for every localization.
#pragma once

#include <cstdint>
#include <string_view>

namespace bw {

enum class HealthState : std::uint8_t {
  init,      ///< no pose yet
  ok,        ///< every source that was ever heard agrees
  degraded,  ///< usable, for a while or with care
  lost       ///< do not drive by it
};

constexpr std::string_view to_string(HealthState state) {
  switch (state) {
    case HealthState::init:
      return "INIT";
    case HealthState::ok:
      return "OK";
    case HealthState::degraded:
      return "DEGRADED";
    case HealthState::lost:
      return "LOST";
  }
  return "unknown";
}

}  // namespace bw
