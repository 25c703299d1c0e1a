// Where a path turns back, so that a robot has to stop and turn there.
#pragma once

#include <cstddef>
#include <vector>

#include "components/local_planner/plan_line.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

/// Indices, rising, of the poses at which the way over the next 0.25 m leads back (by more than 103 degrees) from the way of the
/// last 0.25 m. Headings of the poses do not count. `along` [m]: of each pose on `line`, the line through `poses`.
std::vector<std::size_t> cusps_of(const std::vector<Pose2>& poses, const std::vector<double>& along,
                                  const PlanLine& line);

}  // namespace bw
