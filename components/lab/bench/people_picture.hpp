// The tracks of a run as one picture: from above, beside the labels of each stretch; their distance from the robot, and
// the life of each, over time.
#pragma once

#include <string>

#include "components/lab/bench/bench_people.hpp"

namespace bw {

/// SVG.
std::string people_picture(const PeopleRun& run);

}  // namespace bw
