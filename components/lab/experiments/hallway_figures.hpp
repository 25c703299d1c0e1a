// The figures of E6: the source's Figures 3.9 and 3.12, and the largest collision index of every drive. Each a whole
// <figure>, or nothing where there is nothing to show.
#pragma once

#include <string>
#include <vector>

#include "components/lab/experiments/hallway_experiment.hpp"

namespace bw {

/// The collision index along the drives whose course was kept; by ideal senses, people who react.
std::string hallway_courses(const std::vector<HallwayDrive>& drives, const std::string& source);

/// The largest index of every drive by ideal senses, in every setting.
std::string hallway_largest_indices(const std::vector<HallwayDrive>& drives);

}  // namespace bw
