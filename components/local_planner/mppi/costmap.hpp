// What it costs to be at a position: the inflated costmap that Nav2's critic looks into, made anew from the
// shapes of a problem in each cycle.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "components/local_planner/mppi/mppi_options.hpp"
#include "components/model/planning.hpp"

namespace bw::mppi {

/// Costs of Nav2's costmap.
inline constexpr double kInscribed = 253.0;   ///< from here on the robot touches
inline constexpr double kMaxWithout = 252.0;  ///< just before that

/// By the distance between the middle of the robot and the nearest obstacle: 253 up to the robot's radius,
/// beyond it 252 exp(-kCostScalingFactor (distance - radius)), 0 from the inflation radius on. Not rounded
/// to whole numbers.
double inflated_cost(double distance, double robot_radius, const InflationOptions& options);

/// A square of cells around the robot, aligned with base_link, so that a scene seen otherwise costs the same.
class Costmap {
 public:
  /// Static obstacles and, if `movers`, confirmed movers where they are now (local_planner/theory.md 7.10),
  /// up to `reach` [m] from the robot.
  /// Cells are larger than asked for where there were more than 241 x 241 of them.
  Costmap(const PlanningProblem& problem, const InflationOptions& options, double reach, bool movers);

  /// Of the cell of a position in base_link; 0 outside.
  double at(double x, double y) const {
    const double column = x * per_metre_ + middle_, row = y * per_metre_ + middle_;
    const bool inside = column >= 0.0 && row >= 0.0 && column < side_ && row < side_;
    return inside ? cost_(static_cast<Eigen::Index>(column), static_cast<Eigen::Index>(row)) : 0.0;
  }
  bool touches(double x, double y) const { return at(x, y) >= kInscribed; }

 private:
  double middle_ = 0.0;  ///< of the cell of the robot, in cells from the corner
  double side_ = 0.0;    ///< in cells
  double per_metre_ = 1.0;
  Eigen::ArrayXXd cost_;  ///< rows are columns of the map: x runs along memory
};

/// Confirmed movers at any time, for the form that looks ahead.
class PredictedCosts {
 public:
  /// Those that can come near within `horizon` [s] to a robot that gets `reach` [m] far.
  PredictedCosts(const PlanningProblem& problem, const InflationOptions& options, double reach,
                 double horizon);

  bool empty() const { return movers_.empty(); }
  /// For positions in base_link at `time` [s] from now: `costs` becomes the larger of what it was and what
  /// movers cost there.
  void raise(Eigen::Ref<const Eigen::ArrayXd> x, Eigen::Ref<const Eigen::ArrayXd> y, double time,
             Eigen::ArrayXd& costs) const;

 private:
  InflationOptions options_;
  Pose2 pose_;
  double robot_radius_ = 0.0;
  std::vector<Mover> movers_;
};

}  // namespace bw::mppi
