// Floors for tests of localization by laser: many rooms that look alike, and recorded maps.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "components/files/map_file.hpp"
#include "components/mapping/rasterize.hpp"
#include "components/model/occupancy_grid.hpp"
#include "components/model/random.hpp"

namespace bw::localization::test {

/// 20 x 20 m, cells of 5 cm, 4 x 4 rooms of 5 m. Every wall between two rooms has a door of 1.2 m at one of
/// three positions, and two rooms out of three have a cupboard in one of their corners: a single sweep often
/// fits several rooms, a drive of a few metres only one way.
inline OccupancyGrid repeated_rooms(std::uint64_t seed) {
  Random random(seed);
  OccupancyGrid grid{.resolution = 0.05, .origin = {-10.0, -10.0}, .width = 400, .height = 400};
  grid.cells.assign(400 * 400, OccupancyGrid::kFree);
  const auto box = [&](double x, double y, double width, double height) {
    draw_box(grid, grid.origin + Vector2{x, y}, grid.origin + Vector2{x + width, y + height});
  };
  constexpr double kRoom = 5.0;
  constexpr double kWall = 0.09;  // two cells
  constexpr double kDoor = 1.2;
  for (int line = 0; line <= 4; ++line) {
    const double across = line < 4 ? line * kRoom + 0.01 : 4 * kRoom - 0.1;
    for (int room = 0; room < 4; ++room) {
      for (const bool vertical : {false, true}) {
        const double from = room * kRoom;
        double door = kRoom;  // none in outer walls
        if (line > 0 && line < 4) door = 0.5 + 1.4 * static_cast<double>(random.bits() % 3);
        const double after = std::min(door + kDoor, kRoom);
        if (vertical) {
          box(across, from, kWall, door);
          box(across, from + after, kWall, kRoom - after);
        } else {
          box(from, across, door, kWall);
          box(from + after, across, kRoom - after, kWall);
        }
      }
    }
  }
  for (int room = 0; room < 16; ++room) {
    if (random.bits() % 3 == 0) continue;
    const double width = random.uniform(0.3, 0.9);
    const double depth = random.uniform(0.3, 0.5);
    const std::uint64_t corner = random.bits() % 4;
    const double x = (corner & 1U) != 0 ? kRoom - width : 0.1;
    const double y = (corner & 2U) != 0 ? kRoom - depth : 0.1;
    box(room % 4 * kRoom + x, room / 4 * kRoom + y, width, depth);
  }
  return grid;
}

struct NamedMap {
  std::string name;
  OccupancyGrid grid;
};

/// A recorded map; nothing when recorded data are not at hand.
inline std::optional<NamedMap> recorded_map(const std::string& name) {
  const char* shared = std::getenv("BANDWAGON_SHARED");
  if (shared == nullptr) return std::nullopt;
  return NamedMap{name,
                  load_map(std::filesystem::path(shared) / "data" / ("map_" + name) / (name + ".yaml"))};
}

}  // namespace bw::localization::test
