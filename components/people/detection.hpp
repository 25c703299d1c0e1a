// What a sweep of the laser shows that could be a person or a part of one: the words between detector and
// tracker. All in one frame that does not jump (odom), called O here.
#pragma once

#include <algorithm>
#include <vector>

#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw::people {

/// A group of neighbouring beams, human or not.
struct Detection {
  Vector2 position{0.0, 0.0};  ///< estimated centre, not the surface, in O [m]
  Eigen::Matrix2d covariance = 0.01 * Eigen::Matrix2d::Identity();  ///< of the position [m^2]
  double width = 0.0;                                               ///< from the first to the last point [m]
  int points = 0;
  /// Among as many human things as others (detector/classifier.hpp); both together are at most 1.
  double leg_score = 0.0;   ///< how likely it is one leg, 0 to 1
  double body_score = 0.0;  ///< how likely it is a whole person: two legs in one, 0 to 1
  bool occluded = false;    ///< something nearer hides an edge of it: it may be larger
  bool on_static = false;   ///< lies on the map's walls, or on what has long stood there
  double after = 0.0;       ///< when it was seen, from the set's time on [s]

  double human_score() const { return std::max(leg_score, body_score); }
};

/// All of one sweep, and what the sweep could see.
struct DetectionSet {
  Time time;
  int source = 0;  ///< which of several sensors; 0 is the one that odometry's errors are first taken from
  Vector2 sensor{0.0, 0.0};  ///< in O [m]
  std::vector<Detection> detections;
  /// Free distance by direction, so that a tracker knows whether somebody could have been seen: beam i looks
  /// at angle_min + i * angle_increment in O [rad]; a beam without a return holds the range up to which it
  /// would have seen one; an unusable beam holds 0.
  double angle_min = 0.0;
  double angle_increment = 0.0;
  std::vector<float> free_ranges;  ///< [m]
};

}  // namespace bw::people
