// Buildings of one and of two rooms, 4 m by 3 m each. Walls are lines between cells of 0.1 m.
#pragma once

#include "components/lab/bench/buildings/building.hpp"

namespace bw::test {

inline buildings::Building one_room() {
  buildings::Building building;
  building.name = "one room";
  building.walls = {
      {{0.0, 0.0}, {4.0, 0.0}}, {{4.0, 0.0}, {4.0, 3.0}}, {{4.0, 3.0}, {0.0, 3.0}}, {{0.0, 3.0}, {0.0, 0.0}}};
  building.route = {{1.05, 1.55}};
  return building;
}

/// The second to the right of it, with a door of 1 m in the lower corner.
inline buildings::Building two_rooms() {
  buildings::Building building;
  building.name = "two rooms";
  building.walls = {{{0.0, 0.0}, {8.0, 0.0}},
                    {{8.0, 0.0}, {8.0, 3.0}},
                    {{8.0, 3.0}, {0.0, 3.0}},
                    {{0.0, 3.0}, {0.0, 0.0}},
                    {{4.0, 1.0}, {4.0, 3.0}}};
  building.route = {{1.05, 2.05}};
  return building;
}

}  // namespace bw::test
