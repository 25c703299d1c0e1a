// DynaBARN's worlds (Nair et al. 2022): cylinders that go along key frames, again and again; from tables of them
// (protocols.md 8.16). Metres, seconds.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "components/lab/bench/scene_drive.hpp"

namespace bw {

struct DynaBarnObstacle {
  struct Frame {
    double time = 0.0;
    Vector2 position{0.0, 0.0};
  };
  double radius = 0.5;
  double period = 1.0;        ///< after which it is where it began, at once
  std::vector<Frame> frames;  ///< from 0 to the period
};

struct DynaBarnWorld {
  std::string name;
  std::vector<DynaBarnObstacle> obstacles;
};

/// Files world_N.csv of `folder` in order: 0 to 19 are easy, to 39 medium, to 59 hard. Throws std::runtime_error that
/// names file and line for what cannot be read, and without any.
std::vector<DynaBarnWorld> read_dynabarn(const std::filesystem::path& folder);
/// "easy", "medium" or "hard", by the number in its name.
std::string difficulty_of(const DynaBarnWorld& world);

/// From (11, 0) along -x, 20 m, each obstacle at a phase drawn from `seed`.
DriveScene dynabarn_scene(const DynaBarnWorld& world, std::uint64_t seed);

}  // namespace bw
