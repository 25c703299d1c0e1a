// One segment of a band with its Jacobian written out, zero rows too: for tests that look at every entry.
#pragma once

#include <array>
#include <optional>

#include "components/local_planner/teb/segment_cost.hpp"

namespace bw::teb {

struct DenseSegment {
  std::array<double, kSegmentResiduals> residuals{};
  std::array<double, kSegmentResiduals * kSegmentColumns> jacobian{};
};

/// Of the poses a, b and c, each (x, y, theta, dt), of `states`; nothing when an interval is too short.
inline std::optional<DenseSegment> dense_segment(const SegmentModel& model, const double* states,
                                                 SegmentEnd end, const Twist2* start_twist) {
  const Heading a(states), b(states + 4), c(states + 8);
  SegmentMotion motion, next;
  if (!evaluate_motion(model, a, b, motion)) return std::nullopt;
  if (end == SegmentEnd::next_segment && !evaluate_motion(model, b, c, next)) return std::nullopt;
  SegmentRows rows;
  evaluate_segment(model, {a, b, motion, &next, end, start_twist}, rows);
  DenseSegment dense{.residuals = rows.residuals};
  for (std::size_t i = 0; i < rows.active; ++i) {
    const std::size_t first = rows.of_row[i] * kSegmentColumns;
    for (std::size_t j = 0; j < kSegmentColumns; ++j) dense.jacobian[first + j] = rows.jacobian[i][j];
  }
  return dense;
}

}  // namespace bw::teb
