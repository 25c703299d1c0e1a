// The hallway of experiments/protocols.md 8.6: 20 x 6 m, two boxes, two standing people, six walkers who go
// to and fro.
#pragma once

#include "components/world/world_options.hpp"

namespace bw {

inline WorldOptions hallway() {
  WorldOptions options;
  options.start = {1.0, 0.0, 0.0};
  options.walls = {{0, -3, 20, -3}, {20, -3, 20, 3}, {20, 3, 0, 3}, {0, 3, 0, -3}};
  options.boxes = {{6.0, 2.2, 0.8, 0.8, 0.0}, {13.0, -2.2, 0.8, 0.8, 0.0}};
  options.people.scripted.resize(2);
  options.people.scripted[0].waypoints = {{9.0, -1.6}};
  options.people.scripted[1].waypoints = {{9.6, -1.9}};
  options.people.social.walkers = {{4, 1, 18, 1}, {5, 0, 18, 0}, {3, -1, 18, -1},
                                   {18, 1, 2, 1}, {17, 0, 2, 0}, {19, -1, 2, -1}};
  options.people.social.start_jitter = 0.3;
  return options;
}

}  // namespace bw
