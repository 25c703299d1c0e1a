// Flows of people in a corridor and single encounters in the narrow, from seeds (bench/protocols.md 8.17). Frame: x along the
// way, the robot starts at x = 0 at rest. Metres, seconds.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "components/lab/bench/bench_scenes.hpp"
#include "components/lab/bench/scene_drive.hpp"

namespace bw {

/// A row of the table of scenes.
struct FlowScene {
  const char* name;  ///< F1 to F5, G1 to G5b
  const char* what;
  SceneGate gate;
  DriveScene (*make)(std::uint64_t seed);
};

/// All, in order.
const std::vector<FlowScene>& flow_scenes();

/// `drives` of each scene whose name begins with one of `names`, from seed `first` on. Throws std::runtime_error for a name
/// that no scene has.
std::vector<SceneSet> flow_sets(const std::vector<std::string>& names, int drives, std::uint64_t first);

/// Two-way flow of so many persons per square metre.
DriveScene flow_scene(double density, std::uint64_t seed);
/// A door of 0.9 m, and somebody who comes towards it from the other side.
DriveScene door_scene(std::uint64_t seed);
/// Somebody comes round a blind corner.
DriveScene corner_scene(std::uint64_t seed);
/// A row of people who stand, with a gap of 0.8 m or without any.
DriveScene standing_row_scene(std::uint64_t seed);
DriveScene closed_row_scene(std::uint64_t seed);
/// Somebody slow ahead in a corridor of 1.8 m.
DriveScene overtaking_scene(std::uint64_t seed);
/// Somebody who runs at the robot; a child who runs and stops.
DriveScene rusher_scene(std::uint64_t seed);
DriveScene child_scene(std::uint64_t seed);

}  // namespace bw
