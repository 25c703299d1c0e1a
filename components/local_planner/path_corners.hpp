// Where a path turns so sharply that a robot stops and rotates in place: cusps, where it comes back over
// itself, among them.
#pragma once

#include <cstddef>
#include <vector>

#include "components/local_planner/plan_line.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

/// Indices, rising, of the poses at which the path over the next 0.25 m leads off by more than 80 degrees
/// from that over the last 0.25 m; none nearer than that to either end. Headings of the poses do not count:
/// planners such as NavFn leave them at 0, so that they do not tell whether to drive backwards. `along` [m]:
/// of each pose on `line`, the line through `poses`.
std::vector<std::size_t> sharp_corners(const std::vector<Pose2>& poses, const std::vector<double>& along,
                                       const PlanLine& line);

}  // namespace bw
