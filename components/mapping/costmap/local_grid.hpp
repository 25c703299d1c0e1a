// What a laser has seen around the robot: a window of cells in odom that rolls with the robot by whole cells.
//
// One sweep: cells that beams crossed lose one point of evidence, cells that were hit win two (three when
// several beams or a surface say so) up to four. A cell becomes occupied at three points and free again at
// none, so that it does not flicker, and what went away is gone after four sweeps. A hit outweighs every beam
// that crosses the same cell, and so does the surface between the hits of neighbouring beams: without it,
// beams that graze a wall would clear it, for they cross many of its cells before they end. An occupied cell
// nobody hits or crosses any more becomes unknown after `young_time`, or after `decay_time` if it was hit
// often.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "components/mapping/costmap/costmap_options.hpp"
#include "components/model/footprint.hpp"
#include "components/model/laser_sweep.hpp"
#include "components/model/obstacles.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw::costmap {

class LocalGrid {
 public:
  explicit LocalGrid(const GridOptions& options);

  /// For the next sweep. Size and resolution stay.
  void set_options(const GridOptions& options) { options_ = options; }

  /// Takes a sweep in, its scanner in odom. `X_OB`: base_link at that time; the window rolls to have it in
  /// the middle, and what lies under `footprint` is free. `people`: where they are at that time,
  /// in odom; cells whose centre lies within radius + kPeopleMargin are neither marked nor kept. A sweep that
  /// is refused changes nothing; one that is earlier than the last by a second or more first forgets
  /// everything.
  SweepFault add(const LaserSweep& sweep, const Pose2& X_OB, const Footprint& footprint,
                 const std::vector<Disc>& people);

  void clear();  ///< forgets everything; the next sweep may have any time

  /// Forgets the cells with their centre in the axis-aligned square of this edge [m] around a point in odom,
  /// or all others.
  void clear_inside(const Vector2& center, double edge) { clear_square(center, edge, true); }
  void clear_outside(const Vector2& center, double edge) { clear_square(center, edge, false); }

  /// Free (0), occupied (100) or unknown (-1), in odom. Valid until the next call.
  const OccupancyGrid& cells() const { return grid_; }

  /// Where the surface runs through each occupied cell, from its centre [cells]: the mean of its hits, taken
  /// together with those of the cell behind it as seen from its free side. Zero where no cell is occupied.
  const std::vector<Eigen::Vector2f>& surface() const { return surface_; }

 private:
  struct Cell {
    float age = 0.0F;  ///< since the last hit [s]
    float dx = 0.0F;   ///< mean of the hits, from the centre [cells]
    float dy = 0.0F;
    std::uint8_t evidence = 0;
    std::uint8_t hits = 0;    ///< sweeps that hit it; stays at 255
    std::uint8_t weight = 0;  ///< of the mean
  };
  /// What one sweep says of a cell; a greater value outweighs a smaller one.
  enum Mark : std::uint8_t { kNothing, kSeen, kCrossed, kKept, kHit, kUnderRobot, kPerson };

  /// Of the points of one sweep in one cell.
  struct Sum {
    float dx = 0.0F;  ///< from the cell's centre [cells]
    float dy = 0.0F;
    int points = 0;
  };

  Vector2 to_cells(const Vector2& p) const { return (p - grid_.origin) / grid_.resolution; }
  void roll_to(const Vector2& center);
  void clear_square(const Vector2& center, double edge, bool inside);
  void mark_disc(const Vector2& center, double radius, Mark mark);
  void mark_under(const Footprint& footprint, const Pose2& X_OB);
  void draw(const LaserSweep& sweep);
  void cross(const Vector2& from, const Vector2& unit, double range, bool hit);
  void hit(const Vector2& point, Mark mark);
  void link(const Vector2& a, const Vector2& b, Mark mark);
  void add_point(int column, int row, const Vector2& point, Mark mark);
  void raise(std::size_t cell, Mark mark) { marks_[cell] = std::max(marks_[cell], mark); }
  void judge(double dt);
  static void win(Cell& cell, std::int8_t& value, const Sum& sum);
  void fade(Cell& cell, std::int8_t& value) const;
  static float trust(const Cell& cell);
  void find_surface();

  GridOptions options_;
  OccupancyGrid grid_;
  std::int64_t column0_ = 0;  ///< of the window's lower left cell, counted from the origin of odom
  std::int64_t row0_ = 0;
  bool empty_ = true;
  Time time_;
  std::vector<Cell> cells_;
  std::vector<Mark> marks_;
  std::vector<std::int32_t> sum_of_;  ///< index into sums_ + 1; 0: none
  std::vector<Sum> sums_;
  std::vector<Eigen::Vector2f> surface_;
};

}  // namespace bw::costmap
