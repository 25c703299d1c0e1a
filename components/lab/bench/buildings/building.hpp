// Buildings from seeds, with a route through each. Frame: map, with the start of the route as its origin and
// turned by a drawn angle against the walls, so that none of them lies along the cells of a grid. Metres.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "components/model/obstacles.hpp"

namespace bw::buildings {

enum class BuildingKind {
  office,     ///< 30 furnished rooms along a rectangle of corridors
  corridors,  ///< three long corridors and two across; hardly a feature on the walls
  loop,       ///< one corridor in a ring of 400 m
  pillars,    ///< a hall of pillars that all look the same
  warehouse,  ///< aisles between shelves
  campus      ///< 480 furnished rooms along ten corridors, 200 x 200 m: two hours
};
/// But for the campus, which takes long.
inline constexpr std::array kBuildingKinds = {BuildingKind::office, BuildingKind::corridors,
                                              BuildingKind::loop, BuildingKind::pillars,
                                              BuildingKind::warehouse};
const char* to_text(BuildingKind kind);

struct Building {
  std::string name;            ///< kind and seed
  std::vector<Segment> walls;  ///< of walls, furniture, pillars and shelves; closed outlines
  std::vector<Vector2> rooms;  ///< centre of each room; empty where there are none
  /// Corners of the way a robot takes, kRouteClearance or more from every wall. It sees everything and comes
  /// back to places, in the same direction and in the opposite one.
  std::vector<Vector2> route;
};

inline constexpr double kRouteClearance = 0.4;  ///< [m]

/// Sizes, furniture and route vary with the seed; the same seed gives the same bytes.
Building make_building(BuildingKind kind, std::uint64_t seed);
/// That office after its furniture was moved; 0: as it is.
Building make_office(std::uint64_t seed, std::uint64_t arrangement);

}  // namespace bw::buildings
