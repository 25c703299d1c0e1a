// The figures of the page of E3 and E4: the source's Figures 3.3 and 3.4, and its Table 3.2 as a picture. Each a
// whole <figure>.
#pragma once

#include <string>

#include "components/lab/experiments/edwa_experiment.hpp"

namespace bw {

/// Figure 3.3: the ways of everybody in every scene with every pairing; first seed.
std::string edwa_ways(const EdwaTable& table);

/// Figure 3.4: delta_min and speed over time; first seed.
std::string edwa_courses(const EdwaTable& table);

/// Table 3.2: passing velocities, published and of all seeds.
std::string edwa_velocities(const EdwaTable& table);

}  // namespace bw
