// What this user may ask of the scheduler and of memory, for the loop that drives the base.
#pragma once

#include "runtime/cli/doctor_report.hpp"

namespace bw::cli {

void check_realtime_rights(DoctorReport& report);

}  // namespace bw::cli
