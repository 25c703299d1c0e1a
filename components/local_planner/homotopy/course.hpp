// From where to where topologies are explored, and for which robot.
#pragma once

#include "components/local_planner/homotopy/homotopy_options.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::homotopy {

/// Start and goal in the planning frame.
struct Course {
  Vector2 start{0.0, 0.0};
  Vector2 goal{0.0, 0.0};
  double robot_radius =
      0.3;  ///< of the largest disc in the footprint [m]: a band may turn the rest out of the way
  double clearance = 0.2;  ///< wanted gap [m] to obstacles: the band's min_obstacle_dist
  double v_max = 1.0;      ///< [m/s], above zero: tells when the robot meets a mover

  double length() const { return (goal - start).norm(); }
  /// Unit vector to the goal; zero when start and goal coincide.
  Vector2 heading() const {
    const double l = length();
    return l > 0.0 ? Vector2((goal - start) / l) : Vector2(0.0, 0.0);
  }
  /// Unit vector to the left of it.
  Vector2 left() const {
    const Vector2 h = heading();
    return {-h.y(), h.x()};
  }
  /// Seconds after which a robot at v_max may be at `point`.
  double earliest_time(const Vector2& point) const { return (point - start).norm() / v_max; }
  /// Gap [m] that edges of the graph keep: half of the wanted one beside keypoints, all of it in the random
  /// roadmap.
  double edge_clearance(const HomotopyOptions& options) const {
    return options.method == Vertices::roadmap ? clearance : 0.5 * clearance;
  }
};

}  // namespace bw::homotopy
