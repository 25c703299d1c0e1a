// The stretch of the plan ahead that the critics look at, as points in base_link.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "components/local_planner/mppi/costmap.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::mppi {

struct LocalPath {
  Eigen::ArrayXd x, y;     ///< equally far apart but the last; the first is the nearest to the robot
  std::vector<bool> free;  ///< the robot would touch nothing there
  double spacing = 0.05;   ///< [m]
  Eigen::Index size() const { return x.size(); }
};

/// As dense as the plans of Nav2's planners on their costmaps, 0.05 m, or 400 points for a longer stretch.
/// `plan` is not empty.
LocalPath local_path(const std::vector<Pose2>& plan, const Pose2& robot, double length,
                     const Costmap& costmap);

/// The furthest of the points that some end of a motion is nearest to; `x`, `y`: of the ends.
Eigen::Index furthest_reached(const LocalPath& path, Eigen::Ref<const Eigen::ArrayXd> x,
                              Eigen::Ref<const Eigen::ArrayXd> y);

}  // namespace bw::mppi
