// `lost`: as the localization says on /diagnostics.
#include "components/localization/health.hpp"
#include "runtime/event.hpp"

using bw::EventRule;
using bw::HealthState;

BW_EVENT(lost, "localization", "/diagnostics", "the localization is LOST",
         {{.field = "status[].name", .rule = EventRule::is, .text = "{name}"},
          {.field = "status[].message",
           .rule = EventRule::begins_with,
           .text = std::string(to_string(HealthState::lost))}})
