// How far the robot's own opinion of where it is lies from the truth.
#pragma once

#include "components/evaluation/truth_sample.hpp"

namespace bw {

class PoseErrors {
 public:
  void set_truth(const TruthSample& truth) { truth_ = truth; }
  /// An estimate in map at `time`. The truth is carried there along its arc; estimates more than 0.2 s away
  /// from it, not finite, or before any truth do not count.
  void add(Time time, const Pose2& X_MB);

  int count() const { return count_; }
  double rms_position() const;  ///< [m]; NaN before the first
  double rms_heading() const;   ///< [rad]; NaN before the first
  double max_position() const;  ///< [m]; NaN before the first

 private:
  TruthSample truth_{.X_MB = {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}};
  int count_ = 0;
  double squares_ = 0.0;          // [m^2]
  double heading_squares_ = 0.0;  // [rad^2]
  double worst_ = 0.0;            // [m]
};

}  // namespace bw
