// The figures of E6: the source's Figures 3.9 and 3.12, and the largest collision index of every drive.
// Without pictures where there is nothing to show.
#pragma once

#include <string>
#include <vector>

#include "components/lab/experiments/hallway_experiment.hpp"
#include "components/lab/report/document.hpp"

namespace bw {

/// The collision index along the drives of an episode whose course was kept; by ideal senses, people who
/// react.
report::Figure hallway_courses_figure(const std::vector<HallwayDrive>& drives, const std::string& episode,
                                      const std::string& source);

/// The largest index of every drive by ideal senses, in every setting.
report::Figure hallway_largest_figure(const std::vector<HallwayDrive>& drives);

}  // namespace bw
