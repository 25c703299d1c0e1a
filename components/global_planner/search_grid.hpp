// A map prepared for many searches: what a step costs, where one may step, and which cells hang together.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "components/global_planner/narrow_cell.hpp"
#include "components/global_planner/options.hpp"
#include "components/model/capsule_index.hpp"
#include "components/model/footprint.hpp"
#include "components/model/obstacles.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw {

/// All that a search touches about a cell, in eight bytes, so that a visit is one access to memory.
struct SearchCell {
  std::uint32_t g = 0;          ///< cost from the start; valid when `generation` is that of the search
  std::uint16_t cost = 0;       ///< of a straight step into this cell [kUnit = one free cell]; 0: blocked
  std::uint8_t generation = 0;  ///< search that wrote `g`
  std::uint8_t moves = 0;       ///< bit d: the step to neighbour d (kSteps) is allowed
};

struct GridStep {
  int dx = 0;
  int dy = 0;
};

/// Counter-clockwise from +x: even ones are straight, odd ones diagonal.
inline constexpr GridStep kSteps[8] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};

/// Integer costs: kUnit is a straight step through a cell with full clearance. 8119 / 5741 is a convergent of
/// sqrt(2), so that the diagonal is right to 1e-8.
inline constexpr std::uint32_t kUnit = 5741;
inline constexpr std::uint32_t kDiagonalUnit = 8119;
inline constexpr std::uint32_t kMaxStep = 2 * 0xffffu;  ///< bound of any step's cost

/// Cost of a step into a cell; the fraction is sqrt(2), rounded so that a free diagonal is kDiagonalUnit.
inline std::uint32_t step_cost(std::uint32_t cell_cost, bool diagonal) {
  return diagonal ? (cell_cost * 46341u + 16384u) >> 15 : cell_cost;
}

/// The cells of a map with a blocked rim of one cell, so that neighbours always exist. Cells are named by
/// (x, y) in the rimmed grid: (1, 1) is cell (0, 0) of the map.
class SearchGrid {
 public:
  static constexpr int kMaxSide = 65'000;  ///< coordinates fit 16 bits

  /// Obstacles are the map's cells, half a cell around their middles and what joins neighbours, and `shapes`
  /// (in map, exact). Clearance is the distance from a position to the nearest of them. A cell is free where
  /// the footprint is, at the position of the cell with the most clearance and in some heading: everywhere
  /// from the footprint's outer radius on, nowhere below its inscribed one. It costs (theory.md 7.4)
  ///
  ///   1 + weight ((range - clearance) / (range - inscribed radius))^2   below the range, else 1
  ///
  /// The map's sides must not exceed kMaxSide.
  void build(const OccupancyGrid& map, const Footprint& footprint, const GlobalPlannerOptions& options,
             const StaticObstacles& shapes = {});

  bool empty() const { return cells_.empty(); }
  double resolution() const { return resolution_; }
  int stride() const { return stride_; }
  std::vector<SearchCell>& cells() { return cells_; }
  const std::vector<SearchCell>& cells() const { return cells_; }

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(stride_) + static_cast<std::size_t>(x);
  }
  bool on_map(const Vector2& p) const;
  /// (x, y) of the cell that holds a point on the map.
  std::pair<int, int> cell_of(const Vector2& p) const;
  Vector2 center(int x, int y) const { return origin_ + Vector2{x - 0.5, y - 0.5} * resolution_; }
  /// Where in the cell the robot is to be: the middle, but in narrow cells.
  Vector2 position(int x, int y) const {
    const NarrowCell* cell = narrow(x, y);
    return cell == nullptr ? center(x, y) : cell->position;
  }
  /// What is known of a cell in which position or heading matters; nullptr for all others.
  const NarrowCell* narrow(int x, int y) const {
    const std::uint32_t i = narrow_.empty() ? 0 : narrow_[index(x, y)];
    return i == 0 ? nullptr : &narrow_cells_[i - 1];
  }
  /// Whether the footprint is free, to a millimetre.
  bool fits(const Pose2& pose) const;
  /// The same for the disc that the footprint holds.
  bool holds(const Vector2& position) const;
  Vector2 to_cells(const Vector2& p) const { return (p - origin_) / resolution_ + Vector2{1.0, 1.0}; }
  bool free(int x, int y) const { return cells_[index(x, y)].cost != 0; }
  /// Distance [m] of the cell's middle from the obstacles themselves, without the robot; 0 inside one.
  float clearance(int x, int y) const { return clearance_[index(x, y)]; }
  /// Equal for two free cells exactly when a path joins them (before temporary obstacles).
  std::uint32_t component(int x, int y) const { return component_[index(x, y)]; }
  std::uint32_t max_cost() const { return max_cost_; }

  /// Blocks, until unblock(), every cell whose centre is closer than disc radius + outer radius of the robot
  /// to a disc's centre.
  void block(const std::vector<Disc>& discs);
  void unblock();

 private:
  void take_map(const OccupancyGrid& map, const GlobalPlannerOptions& options);
  std::vector<Capsule> outlines() const;
  void take_shape(const Capsule& shape, double range);
  /// Appends those within `reach` [m] of a point, perhaps some twice.
  void find(const Vector2& point, double reach, std::vector<Capsule>& found) const;
  void price(const GlobalPlannerOptions& options);
  bool look_closely(int x, int y, NarrowCell& cell) const;
  bool may_step(int x, int y, const GridStep& step) const;
  void set_moves(int x, int y);
  void label_components();

  double resolution_ = 0.0;
  Vector2 origin_{0.0, 0.0};
  Footprint footprint_;
  double inscribed_ = 0.0;
  int stride_ = 0;
  int rows_ = 0;
  std::uint32_t max_cost_ = kUnit;
  std::vector<SearchCell> cells_;
  std::vector<float> clearance_;
  std::vector<std::uint32_t> component_;
  CapsuleIndex obstacles_;
  std::vector<std::uint32_t>
      narrow_;  ///< of each cell its number in narrow_cells_ from 1; empty where there is none
  std::vector<NarrowCell> narrow_cells_;
  std::vector<std::pair<std::size_t, SearchCell>> replaced_;
};

}  // namespace bw
