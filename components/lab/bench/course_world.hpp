// A field of cylinders that a robot crosses without a map, as the BARN benchmark has them (Perille et al.
// 2020): cells of 0.15 m, each empty or with a cylinder of 0.075 m; 30 x 30 of them between two side walls,
// an open place before and behind. In map the path leads from (0, 0) along x to (10, 0).
#pragma once

#include <string>
#include <vector>

#include "components/model/obstacles.hpp"

namespace bw {

struct CourseWorld {
  std::string name;
  std::vector<Disc> posts;  ///< in map
};

inline constexpr double kCourseCell = 0.15;    ///< [m]
inline constexpr double kCoursePost = 0.075;   ///< radius [m]
inline constexpr int kCourseSide = 30;         ///< cells of the field in both directions
inline constexpr double kCourseLength = 10.0;  ///< from start to goal [m]
inline constexpr double kCourseReached = 1.0;  ///< distance to the goal that counts as reached [m]

/// Middle of the cell `along` the path and `across` it, from the right; the field is 0 to 29 in both, the
/// open place before it has along < 0.
Vector2 course_cell(int along, int across);

/// How hard it is.
struct CourseMeasures {
  double filled = 0.0;  ///< share of the field's cells with a cylinder, side walls included
  double path_length =
      0.0;  ///< length of the shortest path from start to goal of a disc of kCourseInscribed [m]; 0: none
  double clearance = 0.0;  ///< mean distance to the nearest cylinder along that way [m]
  double narrowest = 0.0;  ///< this distance at the narrowest place of the widest path [m]
};

/// Radius of the largest disc in the body of 0.51 x 0.43 m [m].
inline constexpr double kCourseInscribed = 0.215;

/// On a grid of 0.025 m with exact distances, paths of 16 directions: 2.7 % too long at most. What lies
/// beyond the ends of the side walls is open, but no path leads around them.
CourseMeasures measure(const CourseWorld& world);

/// What the measures of the ten given worlds span (barn_worlds): generated ones lie within.
struct CourseRanges {
  CourseMeasures least;
  CourseMeasures most;

  bool contain(const CourseMeasures& m) const;
};
/// Least and most of each measure. Throws std::invalid_argument without any.
CourseRanges ranges_of(const std::vector<CourseMeasures>& measures);

}  // namespace bw
