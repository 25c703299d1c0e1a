// A* over a prepared grid (Hart, Nilsson and Raphael 1968).
#pragma once

#include <cstdint>
#include <vector>

#include "components/global_planner/bucket_queue.hpp"
#include "components/global_planner/search_grid.hpp"

namespace bw {

struct GridCell {
  std::uint16_t x = 0;
  std::uint16_t y = 0;
  bool operator==(const GridCell&) const = default;
};

struct GridPath {
  std::vector<GridCell> cells;             ///< from start to goal; empty: there is no path
  std::vector<std::uint32_t> cost_so_far;  ///< of each cell, in kUnit
  std::size_t expanded = 0;
  bool too_far = false;  ///< some paths were cut because their cost does not fit the counter
};

/// Finds a cheapest 8-connected path. The octile heuristic is admissible because no cell costs less than 1.
/// Ties go to the larger g. Generation stamps replace clearing between searches.
class AStar {
 public:
  GridPath search(SearchGrid& grid, GridCell start, GridCell goal);
  /// The grid was rebuilt: its stamps start anew.
  void grid_changed() { generation_ = 0; }

 private:
  struct Entry {
    GridCell cell;
    std::uint32_t g = 0;
    std::uint8_t onward = 0xff;  ///< moves worth trying, by the step that led here
  };

  void next_generation(SearchGrid& grid);

  BucketQueue<Entry> queue_;
  std::uint8_t generation_ = 0;
};

}  // namespace bw
