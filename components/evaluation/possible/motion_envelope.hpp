// What no motion can leave: speeds, headings and positions that a robot with bounded accelerations can have
// after a time.
#pragma once

#include <array>

#include "components/evaluation/possible/search_scene.hpp"

namespace bw::possible {

struct Range {
  double low = 0.0;
  double high = 0.0;
};

class MotionEnvelope {
 public:
  static constexpr int kDirections = 48;

  MotionEnvelope(const MotionState& start, const MotionBounds& bounds);

  /// Speeds [m/s] that are possible at some time up to `elapsed` [s] after the start.
  Range speeds(double elapsed) const;
  /// Turn rates [rad/s] likewise.
  Range turn_rates(double elapsed) const;
  /// Headings less the first one [rad], unwrapped, at `elapsed`.
  Range heading_change(double elapsed) const;

  /// Moves the half-planes on to `elapsed` [s]; times rise.
  void advance_to(double elapsed);
  /// Columns [m] of the line y = const that the half-planes hold, each half-plane widened by `reach` (|n_x| +
  /// |n_y|); low > high: none. Relative to the position of the start.
  Range across(double y, double reach) const;

 private:
  MotionState start_;
  MotionBounds bounds_;
  double elapsed_ = 0.0;
  std::array<double, kDirections> support_{};  ///< [m] in direction 2 pi k / kDirections
};

}  // namespace bw::possible
