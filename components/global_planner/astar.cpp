#include "components/global_planner/astar.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

namespace bw {
namespace {

constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();
// Beyond this g a step and the heuristic could overflow.
constexpr std::uint32_t kFarthest = kNever - kMaxStep - SearchGrid::kMaxSide * kDiagonalUnit;

// After a step in direction d the cell it came from is dearer than before it, and so are the two beside that
// one where a step leads to them from there: no search goes back. By d and the moves of where the step began.
using OnwardMoves = std::array<std::array<std::uint8_t, 256>, 8>;

constexpr OnwardMoves onward_moves() {
  OnwardMoves table{};
  for (unsigned d = 0; d < 8; ++d) {
    const unsigned beside =
        d % 2 == 0 ? 2 : 1;  // steps of an eighth turn from d to the cells beside, from where it began
    for (unsigned moves = 0; moves < 256; ++moves) {
      unsigned behind = 1u << (d + 4) % 8;
      if ((moves >> (d + beside) % 8 & 1u) != 0) behind |= 1u << (d + 3) % 8;
      if ((moves >> (d + 8 - beside) % 8 & 1u) != 0) behind |= 1u << (d + 5) % 8;
      table[d][moves] = static_cast<std::uint8_t>(~behind);
    }
  }
  return table;
}

constexpr OnwardMoves kOnward = onward_moves();

std::uint32_t octile(int x, int y, const GridCell& goal) {
  const auto dx = static_cast<std::uint32_t>(std::abs(x - goal.x));
  const auto dy = static_cast<std::uint32_t>(std::abs(y - goal.y));
  return kUnit * std::max(dx, dy) + (kDiagonalUnit - kUnit) * std::min(dx, dy);
}

// From the goal to the cheapest predecessor each time, going straight on where there is a choice.
void trace_back(const SearchGrid& grid, GridCell start, GridCell goal, std::uint8_t generation,
                GridPath& path) {
  GridCell at = goal;
  unsigned heading = 0;
  for (;;) {
    const SearchCell& cell = grid.cells()[grid.index(at.x, at.y)];
    path.cells.push_back(at);
    path.cost_so_far.push_back(cell.g);
    if (at == start) break;
    for (unsigned heading_change = 0; heading_change < 8; ++heading_change) {
      const unsigned d = (heading + heading_change) % 8;
      if ((cell.moves >> d & 1u) == 0) continue;
      const GridCell before{static_cast<std::uint16_t>(at.x + kSteps[d].dx),
                            static_cast<std::uint16_t>(at.y + kSteps[d].dy)};
      const SearchCell& candidate = grid.cells()[grid.index(before.x, before.y)];
      if (candidate.generation == generation && candidate.g + step_cost(cell.cost, d % 2 == 1) == cell.g) {
        at = before;
        heading = d;
        break;
      }
    }
  }
  std::reverse(path.cells.begin(), path.cells.end());
  std::reverse(path.cost_so_far.begin(), path.cost_so_far.end());
}

}  // namespace

void AStar::next_generation(SearchGrid& grid) {
  if (++generation_ != 0) return;
  for (SearchCell& cell : grid.cells()) cell.generation = 0;
  generation_ = 1;
}

GridPath AStar::search(SearchGrid& grid, GridCell start, GridCell goal) {
  GridPath path;
  next_generation(grid);
  SearchCell* const cells = grid.cells().data();
  const std::ptrdiff_t stride = grid.stride();
  std::ptrdiff_t offset[8];
  for (unsigned d = 0; d < 8; ++d) offset[d] = kSteps[d].dy * stride + kSteps[d].dx;
  const std::size_t goal_index = grid.index(goal.x, goal.y);

  SearchCell& first = cells[grid.index(start.x, start.y)];
  first.g = 0;
  first.generation = generation_;
  // A step raises f by at most its own cost and the heuristic's change.
  const std::uint32_t first_f = octile(start.x, start.y, goal);
  queue_.reset(first_f, step_cost(grid.max_cost(), true) + kDiagonalUnit);
  queue_.push(first_f, {start, 0});
  std::uint32_t best = start == goal ? 0 : kNever;

  while (!queue_.empty()) {
    const Entry entry = queue_.pop();
    const std::size_t i = grid.index(entry.cell.x, entry.cell.y);
    // A stale entry, or one that cannot beat the path already found: inside a bucket keys are unordered.
    if (cells[i].g != entry.g ||
        (best != kNever && entry.g + octile(entry.cell.x, entry.cell.y, goal) >= best)) {
      continue;
    }
    if (entry.g > kFarthest) {
      path.too_far = true;
      continue;
    }
    ++path.expanded;
    for (unsigned moves = cells[i].moves & entry.onward; moves != 0; moves &= moves - 1) {
      const auto d = static_cast<unsigned>(__builtin_ctz(moves));
      const std::size_t n = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + offset[d]);
      SearchCell& next = cells[n];
      const std::uint32_t g = entry.g + step_cost(next.cost, d % 2 == 1);
      if (next.generation == generation_ && next.g <= g) continue;
      const int x = entry.cell.x + kSteps[d].dx;
      const int y = entry.cell.y + kSteps[d].dy;
      const std::uint32_t f = g + octile(x, y, goal);
      if (f >= best) continue;
      next.g = g;
      next.generation = generation_;
      if (n == goal_index) {
        best = g;
      } else {
        queue_.push(
            f,
            {{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)}, g, kOnward[d][cells[i].moves]});
      }
    }
  }
  if (best != kNever) trace_back(grid, start, goal, generation_, path);
  return path;
}

}  // namespace bw
