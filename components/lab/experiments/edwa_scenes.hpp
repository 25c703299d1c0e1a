// The scenes of experiment E3 (Table 3.2; protocols.md 8.3). The dissertation shows them as a picture only:
// start and goal positions are proposals.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw {

/// One robot's errand, straight from start to goal; it begins at rest, looking at its goal.
struct StartAndGoal {
  Pose2 start;
  Pose2 goal;
};

/// The robot under test is the first.
struct EdwaScene {
  std::string name;
  std::vector<StartAndGoal> errands;
};

constexpr int kEdwaScenes = 4;

/// "S1 head-on", ...; `index` from 0.
std::string_view edwa_scene_name(int index);

/// Scene `index` (0 to 3) with the positions of the others jittered by `seed`.
EdwaScene edwa_scene(int index, std::uint64_t seed);

}  // namespace bw
