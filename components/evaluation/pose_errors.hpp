// How far the robot's own opinion of where it is lies from the truth.
#pragma once

#include <optional>
#include <vector>

#include "components/evaluation/truth_sample.hpp"

namespace bw {

class PoseErrors {
 public:
  /// A truth without speed (NaN), such as a reference without heading, is interpolated between its samples.
  void set_truth(const TruthSample& truth);
  /// An estimate in map at `time`. The truth is carried there along its arc; estimates more than 0.2 s away
  /// from it, not finite, or before any truth do not count. Without speed, an estimate counts when the truth
  /// after it is there and follows the one before within half a second.
  void add(Time time, const Pose2& X_MB);

  int count() const { return count_; }
  double mean_position() const;  ///< [m]; NaN before the first
  double rms_position() const;   ///< [m]; NaN before the first
  double rms_heading() const;    ///< [rad]; NaN before the first, and where the truth has no heading
  double max_position() const;   ///< [m]; NaN before the first

 private:
  struct Estimate {
    Time time;
    Pose2 X_MB;
  };

  [[nodiscard]] bool has_speed() const { return is_finite(truth_.X_MB) && is_finite(truth_.twist); }
  /// False when the estimate is newer than the truth.
  bool compare_between(const Estimate& estimate);
  /// The heading of the truth may be NaN.
  void count(const Pose2& X_MB, const Pose2& true_X_MB);

  TruthSample truth_{.X_MB = {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}};
  std::optional<TruthSample> before_;  ///< the truth before it
  std::vector<Estimate> waiting_;      ///< for the next truth
  int count_ = 0;
  int heading_count_ = 0;
  double sum_ = 0.0;              // [m]
  double squares_ = 0.0;          // [m^2]
  double heading_squares_ = 0.0;  // [rad^2]
  double worst_ = 0.0;            // [m]
};

}  // namespace bw
