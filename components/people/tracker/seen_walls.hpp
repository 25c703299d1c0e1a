// What was seen to stand lately, as far as people cannot walk through it: a grid in S (the tracker's frame)
// that takes no more memory however far the robot drives. Near people nothing is remembered, that who stands
// does not become a wall.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "components/people/detection.hpp"

namespace bw::people {

class SeenWalls {
 public:
  SeenWalls();

  /// One sweep in S at `now` [s, from the tracker's own origin], with the positions of people.
  void add(const DetectionSet& sweep, double now, std::span<const Vector2> people);

  /// Whether beams ended here for a second on end, half a minute ago at most.
  bool contains(const Vector2& p_S) const {
    if (!is_near(p_S)) return false;
    const std::int32_t column = to_cell(p_S.x());
    const std::int32_t row = to_cell(p_S.y());
    const Cell& cell = cells_[slot_of(column, row)];
    return cell.column == column && cell.row == row && cell.last - cell.since >= kWallAge &&
           now_ - cell.last <= kRemembered;
  }

  void reset();

 private:
  static constexpr std::int32_t kSide = 256;  ///< cells; a power of two
  static constexpr double kCell = 0.1;        ///< [m]
  static constexpr double kFarthest = 1e6;    ///< [m]
  static constexpr float kWallAge = 1.0F;     ///< [s] what stands so long is a wall
  static constexpr float kRemembered =
      30.0F;  ///< [s] for so long odometry is good enough to remember positions

  struct Cell {
    std::int32_t column = 0;  ///< of the whole plane: a slot serves all cells that are kSide apart
    std::int32_t row = 0;
    float since = 0.0F;  ///< beams have ended here since then without a pause [s]
    float last = -1e9F;  ///< the last of them [s]
  };

  static bool is_near(const Vector2& p_S) { return p_S.squaredNorm() < kFarthest * kFarthest; }
  static std::int32_t to_cell(double coordinate) {
    const double cells = coordinate / kCell;
    const auto towards_zero = static_cast<std::int32_t>(cells);
    return towards_zero - (cells < static_cast<double>(towards_zero) ? 1 : 0);
  }
  static std::size_t slot_of(std::int32_t column, std::int32_t row) {
    const auto wrapped = [](std::int32_t i) { return static_cast<std::size_t>(i & (kSide - 1)); };
    return wrapped(row) * kSide + wrapped(column);
  }
  void mark(const Vector2& p_S);

  std::vector<Cell> cells_;
  float now_ = 0.0F;
};

}  // namespace bw::people
