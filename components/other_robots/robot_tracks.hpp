// Another robot's own word about itself as a track among those of people.
//
//   p(t) = p + v t,   cov(t) = C + (a t^2 / 2)^2 I
//
// with C the covariance of its position and a the acceleration by which it may deviate from its velocity.
#pragma once

#include <cstdint>
#include <string>

#include "components/model/tracked_person.hpp"
#include "components/other_robots/other_robots_options.hpp"

namespace bw {

/// Where a robot says to be, in map.
struct RobotReport {
  Time time;
  Pose2 X_MR;
  Twist2 twist;                                          ///< in its own frame
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< of (x, y) [m^2]
};

/// Why a report is not used; empty: it is. `now` is that of whoever uses it.
std::string fault_of(const RobotReport& report, Time now, const OtherRobotsOptions& options);

/// The robot at `time`, as far as its velocity carries it there. X_FM: map in the frame of the track.
TrackedPerson robot_track(const RobotReport& report, const Pose2& X_FM, Time time, std::uint32_t id,
                          double radius, const OtherRobotsOptions& options);

/// A robot whose position and velocity in the frame of the tracks are known, with its predictions.
/// `covariance`: of (x, y) [m^2].
TrackedPerson robot_track(const Vector2& position, const Vector2& velocity, const Eigen::Matrix2d& covariance,
                          Time time, std::uint32_t id, double radius, const OtherRobotsOptions& options);

/// Whether somebody seen at `position` is that robot. A person is not, unless the robot touches them: their
/// centre is a person's radius farther out.
inline bool is_body_of(const Mover& robot, const Vector2& position, double body_margin) {
  return (position - robot.position).norm() <= robot.radius + body_margin;
}

}  // namespace bw
