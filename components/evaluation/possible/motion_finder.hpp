// A motion within the robot's limits that stays clear of everybody, found or not (theory.md 8.10).
//
// Breadth first in steps of h with the extreme accelerations, none, and those that stop: of the states after
// a step one is kept for each cell of (x, y, heading, speed, turn rate), and of too many cells a sample that
// their numbers alone choose. Some of them are followed to the end with the speed they have, and braking. A
// motion that is found is looked at again in small steps with the whole footprint, so "found" is a proof;
// "not found" is none.
#pragma once

#include <optional>
#include <vector>

#include "components/evaluation/possible/search_scene.hpp"

namespace bw::possible {

struct FinderOptions {
  double step = 0.2;        ///< h [s]
  double position = 0.08;   ///< of a cell [m]
  double heading = 0.2;     ///< of a cell [rad]
  double speed = 0.15;      ///< of a cell [m/s]
  double turn_rate = 0.25;  ///< of a cell [rad/s]
  int most_states = 4000;   ///< kept after a step
  int followed = 12;        ///< states of a step that are followed to the end
};

/// States 0.05 s apart from `start` until `until` [s]; nothing where none was found.
std::optional<std::vector<MotionState>> find_motion(const SearchScene& scene, const MotionState& start,
                                                    const MotionBounds& bounds, double until,
                                                    const FinderOptions& options = {});

}  // namespace bw::possible
