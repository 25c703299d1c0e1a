// How far a robot disc at some position is from everything around it, all of it frozen (theory.md 5.2: DWA
// sees moving obstacles as standing). Flat arrays: the distance is asked for thousands of times per cycle.
#pragma once

#include <Eigen/Core>

#include "components/model/obstacles.hpp"

namespace bw::dwa {

class ClearanceField {
 public:
  /// Obstacles and confirmed movers (where they are now; local_planner/theory.md 7.10) whose gap to a robot
  /// disc of `robot_radius` [m] at `center` is less than `reach` [m].
  ClearanceField(const StaticObstacles& obstacles, const std::vector<Mover>& movers, const Vector2& center,
                 double robot_radius, double reach);

  /// Gap between outlines with the robot at `p`, negative in contact; infinite without obstacles. Changes by
  /// no more than `p` moves.
  double at(const Vector2& p) const;

 private:
  // Points, discs and movers: centres, and radii with the robot's.
  Eigen::ArrayXd x_, y_, radius_;
  std::vector<Segment> segments_;
  double robot_radius_ = 0.0;
};

}  // namespace bw::dwa
