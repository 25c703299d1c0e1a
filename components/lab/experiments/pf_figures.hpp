// The figures of the page of E2: the source's Figure 2.5 and its Table 2.1 as a picture. Each a whole <figure>.
#pragma once

#include <string>

#include "components/lab/experiments/pf_experiment.hpp"

namespace bw {

/// Figure 2.5: the way in its three parts, with each set of readings under the roof; first seed.
std::string pf_ways(const PfTable& table);

/// The error over time of the same runs.
std::string pf_errors_over_time(const PfTable& table);

/// Table 2.1, published and of all seeds.
std::string pf_statistics(const PfTable& table);

}  // namespace bw
