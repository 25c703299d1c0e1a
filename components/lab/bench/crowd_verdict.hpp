// Whether the contacts of a drive among walkers could have been avoided (possible/theory.md 8.10).
#pragma once

#include <vector>

#include "components/lab/bench/crowd_episode.hpp"

namespace bw {

/// Of each contact of `episode`, which was driven in `scene`. Walkers who react to nobody are known at any
/// time, those who do until the end of the drive; they would have walked otherwise beside another robot, and
/// the verdict is for people who walk as they did.
std::vector<JudgedContact> judge_crowd(const Scene& scene, const SceneFile& file,
                                       const CrowdEpisode& episode);

}  // namespace bw
