// The first pose, from several measurements that agree, never from one sample.
//
// Wheels give a path in an odometry frame O; the pose of O in map is asked for.
//  - With a compass: heading of O = the readings' medoid (the one with the least sum of distances to the
//    others) averaged with those that agree with it; position = medoid and average of the fixes, likewise.
//  - Without: rotation and shift that carry the path onto the fixes, the worst fix left out as long as it
//    does not fit, once the path is long enough for a heading within `heading_sigma`.
// A majority must agree.
#pragma once

#include <optional>
#include <vector>

#include "components/localization/ekf/ekf_options.hpp"
#include "components/localization/ekf/ekf_state.hpp"

namespace bw::localization {

struct StartPose {
  Time time;
  Pose2 X_MB;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  bool by_compass = false;  ///< the heading is the compass's, with whatever constant error that has
};

class InitialPose {
 public:
  InitialPose(const InitialOptions& options, double gate_probability);

  /// Takes in a measurement that passed check(); a pose as soon as it is known. A PoseReading is one.
  std::optional<StartPose> add(const Measurement& measurement);

  bool has_fixes() const { return static_cast<int>(fixes_.size()) >= options_.kFixes; }
  bool has_headings() const { return static_cast<int>(headings_.size()) >= options_.kHeadings; }
  void restart();

 private:
  struct OdometryPose {
    Time time;
    Pose2 X_OB;
    double heading_variance = 0.0;  ///< of the heading in O [rad^2]
  };
  struct Fix {
    Vector2 p_O;  ///< of the antenna
    Vector2 p_M;
    double variance = 0.0;
    double heading_variance = 0.0;  ///< of the position
  };
  struct Angle {
    double value = 0.0;
    double variance = 0.0;
    double heading_variance = 0.0;  ///< of the position
  };

  OdometryPose pose_at(Time time) const;
  std::optional<Angle> heading_from_compass() const;
  std::optional<StartPose> with_heading(const Angle& theta_MO) const;
  std::optional<StartPose> from_path() const;

  InitialOptions options_;
  double gate1_;
  double gate2_;
  std::vector<OdometryPose> poses_;  // circular by erasing the older half
  std::vector<Fix> fixes_;
  std::vector<Angle> headings_;
};

}  // namespace bw::localization
