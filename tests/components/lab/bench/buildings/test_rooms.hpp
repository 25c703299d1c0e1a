// Rooms of which distances are known in closed form.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "components/lab/bench/buildings/building.hpp"

namespace bw::buildings {

/// Four walls from (0, 0) to (length, width).
inline Building rectangular_room(double length, double width) {
  Building room;
  room.name = "room";
  room.walls = {{{0.0, 0.0}, {length, 0.0}},
                {{length, 0.0}, {length, width}},
                {{length, width}, {0.0, width}},
                {{0.0, width}, {0.0, 0.0}}};
  return room;
}

/// From a place inside, along an angle: the nearer of the two walls that are ahead.
inline double range_in_room(const Vector2& from, double angle, double length, double width) {
  const auto ahead = [](double place, double along, double size) {
    if (along == 0.0) return std::numeric_limits<double>::infinity();
    return ((along > 0.0 ? size : 0.0) - place) / along;
  };
  return std::min(ahead(from.x(), std::cos(angle), length), ahead(from.y(), std::sin(angle), width));
}

}  // namespace bw::buildings
