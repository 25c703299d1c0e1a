// The figures of the page of E1 and E7: the source's Figures 2.2 and 2.4, and ways on recorded logs. Each a whole
// <figure>.
#pragma once

#include <string>

#include "components/lab/experiments/ekf_report.hpp"

namespace bw {

/// Figure 2.2: both ways, the end of each enlarged, and the error over time; placed filter, first seed.
std::string ekf_trajectories(const EkfReport& report);

/// Figure 2.4: mean and variance of the error, published and of all seeds; placed filter.
std::string ekf_statistics(const EkfReport& report);

/// Ways on the recorded logs.
std::string ekf_recorded_ways(const RealDataResults& results);

}  // namespace bw
