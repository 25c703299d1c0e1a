// A plan as a line: where along it something is, and how far beside it.
#pragma once

#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw {

class PlanLine {
 public:
  struct Projection {
    double along = 0.0;   ///< distance from the line's beginning [m]
    double beside = 0.0;  ///< distance from the line [m]
  };

  /// Through the poses of `plan`, which is not empty; a plan of one position is the line there from `robot`.
  /// It goes straight on for `beyond` [m] after its end.
  PlanLine(const std::vector<Pose2>& plan, const Vector2& robot, double beyond);

  /// The point nearest to `point`, of those from `from` to `to` [m]; of equals the first.
  Projection nearest(const Vector2& point, double from, double to) const;
  /// The point `along` [m] the line; its ends beyond them.
  Vector2 at(double along) const;
  /// [m], without what goes on after the end.
  double length() const { return length_; }

 private:
  std::vector<Vector2> points_;  // two or more
  std::vector<double> along_;    // of each
  double length_ = 0.0;
};

}  // namespace bw
