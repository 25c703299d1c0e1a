// Crowd scenes of the rule behind teb_crowd_scenes.yaml, from seeds of our own. Metres, seconds, radians.
//
// The rule, as read off the thirty scenes of that file (180 static discs, 300 walkers):
// - start (0, 0, 0), goal (12, 0, 0), box 14 x 8 m; lengths and speeds have two decimals;
// - six static discs: centre uniform in [2, 10.4] x [-3.5, 3.5], radius 0.2 or 0.3 with equal chance, at
//   least 1.6 m between the edges of any two (nearest in the file: 1.605 m, beside a median of 4.2 m), so
//   that a robot of 0.3 m radius fits between them; no rule keeps them from the goal beyond that range;
// - 6, 10 or 14 walkers in equal shares: radius 0.3, centre uniform in [-0.5, 12.5] x [-3.8, 3.8] wherever
//   the edge is 1.5 m away from the start; they may overlap each other, static discs and the goal;
// - speed uniform in [0.3, 1.2], heading uniform in [-pi, pi).
#pragma once

#include <cstdint>
#include <vector>

#include "components/lab/bench/scene_file.hpp"

namespace bw {

/// The head of teb_crowd_scenes.yaml (limits, weights, box, closed loop) without scenes.
SceneFile crowd_rules();

/// The scene of one seed; seed mod 3 says how many walkers it has.
Scene generate_crowd_scene(std::uint64_t seed);

/// The scenes of seeds first_seed, first_seed + 1, ... `count` must not be negative.
std::vector<Scene> generate_crowd(int count, std::uint64_t first_seed);

/// A dense crowd: the static discs of the same seed, and as many walkers as make `density` persons per square
/// metre of the box (0.3:
/// 34, 0.5: 56), drawn by the same rule, but at the start at least 0.1 m apart from each other and from the
/// discs, edge to edge. `density` in (0, 1].
Scene generate_dense_crowd_scene(std::uint64_t seed, double density);
std::vector<Scene> generate_dense_crowd(int count, std::uint64_t first_seed, double density);

}  // namespace bw
