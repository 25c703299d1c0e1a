// Every cell a straight line goes through, in order (Amanatides and Woo 1987).
#pragma once

#include <cmath>
#include <cstdlib>
#include <limits>

#include "runtime/base/pose2.hpp"

namespace bw {

/// Calls visit(column, row, leave) for each cell that holds a part of the line from `a` to `b` [cells, cell
/// (0, 0) from 0 to 1], from a's cell to b's; `leave` is the share of the line [0 to 1] at which it leaves
/// the cell. A line through a corner takes the cell beside it in x too. visit() returns false to end the
/// walk. The coordinates must be finite and fit into an int.
template <class Visit>
void walk_cells(const Vector2& a, const Vector2& b, Visit&& visit) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  int column = static_cast<int>(std::floor(a.x()));
  int row = static_cast<int>(std::floor(a.y()));
  const int steps = std::abs(static_cast<int>(std::floor(b.x())) - column) +
                    std::abs(static_cast<int>(std::floor(b.y())) - row);
  const Vector2 across = b - a;
  const int right = across.x() > 0.0 ? 1 : -1;
  const int up = across.y() > 0.0 ? 1 : -1;
  const double per_column = across.x() != 0.0 ? 1.0 / std::abs(across.x()) : kNever;
  const double per_row = across.y() != 0.0 ? 1.0 / std::abs(across.y()) : kNever;
  double leave_column = kNever;
  double leave_row = kNever;
  if (across.x() != 0.0) leave_column = (right > 0 ? column + 1 - a.x() : a.x() - column) * per_column;
  if (across.y() != 0.0) leave_row = (up > 0 ? row + 1 - a.y() : a.y() - row) * per_row;
  for (int step = 0; step < steps; ++step) {
    if (leave_column <= leave_row) {
      if (!visit(column, row, leave_column)) return;
      column += right;
      leave_column += per_column;
    } else {
      if (!visit(column, row, leave_row)) return;
      row += up;
      leave_row += per_row;
    }
  }
  visit(column, row, 1.0);
}

}  // namespace bw
