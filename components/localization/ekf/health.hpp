// The health of an EKF from its state.
#pragma once

#include "components/localization/ekf/ekf_options.hpp"
#include "components/localization/ekf/ekf_state.hpp"
#include "components/localization/health.hpp"

namespace bw::localization {

/// Health of an initialised filter at `now` (on the time base of the stamps).
Health assess(const EkfState& state, Time now, Time last_clock_jump, const EkfOptions& options);

}  // namespace bw::localization
