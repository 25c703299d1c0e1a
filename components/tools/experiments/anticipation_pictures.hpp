// Pictures for the page of E5 and E6.
#pragma once

#include <string>
#include <vector>

#include "components/tools/experiments/crossing_experiment.hpp"
#include "components/tools/experiments/hallway_experiment.hpp"

namespace bw {

/// The ways of one seed, a dot every second, of the robot with every planner and of the two people: a whole
/// <svg> element. Every result must hold that run.
std::string crossing_picture(const std::vector<CrossingResult>& results, const CrossingGeometry& geometry,
                             std::size_t run);

/// The largest collision index of every drive in one setting, a column for each planner: a whole <svg>.
std::string index_picture(const std::vector<HallwayDrive>& drives, const std::string& episode,
                          bool people_react);

}  // namespace bw
