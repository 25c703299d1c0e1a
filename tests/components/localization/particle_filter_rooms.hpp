// A floor with rooms of different shapes, and sweeps of a laser in it, for the tests of the particle filter.
#pragma once

#include <cmath>
#include <vector>

#include "components/localization/laser_reading.hpp"
#include "components/model/occupancy_grid.hpp"
#include "components/world/laser_scanner.hpp"

namespace bw::localization {

/// 20 x 20 m, cells of 5 cm, walls 10 cm thick: outer walls, three inner ones with doors, boxes that differ.
inline OccupancyGrid rooms() {
  OccupancyGrid grid{0.05, {0.0, 0.0}, 400, 400, std::vector<std::int8_t>(160'000, OccupancyGrid::kFree)};
  const auto fill = [&](double x0, double y0, double x1, double y1) {
    for (int row = grid.row_of(y0 + 1e-6); row < grid.row_of(y1 - 1e-6) + 1; ++row) {
      for (int column = grid.column_of(x0 + 1e-6); column < grid.column_of(x1 - 1e-6) + 1; ++column)
        grid.cells[grid.index(column, row)] = OccupancyGrid::kOccupied;
    }
  };
  fill(0, 0, 20, 0.1);
  fill(0, 19.9, 20, 20);
  fill(0, 0, 0.1, 20);
  fill(19.9, 0, 20, 20);
  fill(0, 12, 7, 12.1);  // a wall with a door from x = 7 to 9
  fill(9, 12, 20, 12.1);
  fill(12, 0, 12.1, 4);  // a door from y = 4 to 6
  fill(12, 6, 12.1, 12);
  fill(14, 12, 14.1, 16);
  fill(3, 2, 4, 4);
  fill(9, 8, 9.5, 8.5);
  fill(16, 3, 18, 3.5);
  fill(15, 9, 15.4, 9.4);
  fill(5, 16, 7.5, 17);
  fill(17, 15, 18, 19);
  return grid;
}

/// Takes sweeps of 360 beams over 270 degrees, range noise 1 cm.
class Sweeper {
 public:
  explicit Sweeper(const OccupancyGrid& grid, std::uint64_t seed = 1)
      : scene_({}, grid), scanner_({.beams = 360}, Random(seed)) {}

  /// Valid until the next sweep.
  LaserReading sweep(Time time, const Pose2& X_MB, int source = 4) {
    scan_ = scanner_.scan(scene_, {}, X_MB * X_BL);
    LaserReading reading;
    reading.time = time;
    reading.source = source;
    reading.angle_min = scan_.angle_min;
    reading.angle_increment = scan_.angle_increment;
    reading.range_min = LaserOptions{}.range_min;
    reading.range_max = LaserOptions{}.range_max;
    reading.X_FL = X_BL;
    reading.ranges = scan_.ranges;
    return reading;
  }

  static constexpr Pose2 X_BL{0.1, 0.0, 0.0};

 private:
  StaticScene scene_;
  LaserScanner scanner_;
  LaserScan scan_;
};

}  // namespace bw::localization
