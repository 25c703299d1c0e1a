// Which earlier submaps the newest may have seen again (theory.md 10.6).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "components/slam/submap.hpp"
#include "components/slam/uncertain_pose.hpp"

namespace bw::slam {

/// [m] three standard deviations; beyond, a search is dear and finds look-alikes
inline constexpr double kWide = 2.0;

/// So near along the drive that their scans were matched with each other.
bool overlap(std::size_t earlier, std::size_t later, std::span<const Submap> submaps);

/// `others`: poses of all before it in the newest. Those whose walls may lie within `reach` [m] of its own: the
/// nearest, and of those that are far some in turn; `turn` counts on.
std::vector<std::size_t> loop_candidates(std::span<const Submap> submaps,
                                         std::span<const UncertainPose> others, double reach,
                                         std::size_t& turn);

}  // namespace bw::slam
