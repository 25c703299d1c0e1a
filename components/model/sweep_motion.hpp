// Where a scanner was while it took one sweep: a head that rotates takes its beams one after the other, and
// meanwhile the robot moves.
//
// The robot's pose is asked for at a few instants, evenly from the first beam to the last (knots); between
// two of them it moves with one body velocity, rotation included.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "components/model/laser_sweep.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw {

/// The pose on the way from `a` to `b` by one body velocity, which may have a part to the side, after `share`
/// of the time: 0 is a, 1 is b; below 0 and above 1 the path goes on. A rotation by pi or more between the
/// two is taken the short way round.
Pose2 pose_between(const Pose2& a, const Pose2& b, double share);

/// Of base_link in the frame that a sweep is wanted in; nothing when nobody knows.
using PoseAtTime = std::function<std::optional<Pose2>(Time)>;

/// LaserSweep::beam_poses of `sweep`: the scanner at each of its beams, in the frame of `X_FB_at`; X_BL:
/// where it sits on base_link.
/// What lies before the first knot that is known, or after the last, goes on with the mean body velocity
/// between these two: odometry comes a little later than beams. Empty when all beams are of one time
/// (time_increment), and when fewer than two knots are known.
std::vector<Pose2> beam_poses(const LaserSweep& sweep, const Pose2& X_BL, const PoseAtTime& X_FB_at);

}  // namespace bw
