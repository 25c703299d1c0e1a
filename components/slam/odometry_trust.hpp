// How well this robot's odometry keeps to what scans show, learned on the way.
#pragma once

#include "components/slam/refinement.hpp"
#include "components/slam/slam_options.hpp"
#include "components/slam/uncertain_pose.hpp"

namespace bw::slam {

/// Covariance of an odometry step as SlamOptions has it, in the frame of its start.
Eigen::Matrix3d step_covariance(const Pose2& step, const SlamOptions& options);

/// Scales step_covariance(): one base's encoders are ten times as good as another's, and a prior that is too
/// weak lets clutter turn the robot (theory.md 10.1).
class OdometryTrust {
 public:
  OdometryTrust() = default;
  /// What was learned before.
  OdometryTrust(double travel, double turn) : travel_(travel), turn_(turn) {}

  Eigen::Matrix3d covariance(const Pose2& step, const SlamOptions& options) const;

  /// A scan that fits well: the step by odometry alone and after the scan; covariance of the pose before the
  /// scan and information by the scan, all in the frame of the step's start.
  void learn(const Pose2& odometry, const Pose2& corrected, const Eigen::Matrix3d& predicted,
             const Eigen::Matrix3d& information, const SlamOptions& options);

  double travel() const { return travel_; }  ///< factor on the variance along and across
  double turn() const { return turn_; }      ///< factor on the variance of the heading

 private:
  double travel_ =
      0.1;  ///< counted from SlamOptions: most bases' encoders are better, and a corridor is lost by less
  double turn_ = 1.0;
};

}  // namespace bw::slam
