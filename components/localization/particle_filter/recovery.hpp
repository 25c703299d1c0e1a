// Does the scan fit where the estimate says, and if not, where on the map would it? Watches every sweep, used
// or not; searches the map in slices, one per sweep.
//
// Two averages of the fit, a short and a long one (augmented MCL: Gutmann and Fox 2002; Probabilistic
// Robotics, 8.3.3), tell a sudden loss from a map that has always fitted badly. Augmented MCL then strews
// particles at random; here they go to the poses that the search found.
#pragma once

#include <optional>
#include <vector>

#include "components/localization/laser/laser_model.hpp"
#include "components/localization/laser/pose_search.hpp"
#include "components/localization/particle_filter/recovery_options.hpp"
#include "runtime/base/time.hpp"

namespace bw::localization {

class Recovery {
 public:
  Recovery(const RecoveryOptions& options, const PoseSearchOptions& search);

  void set_field(const LikelihoodField& field);
  /// From a new start; `anywhere`: the pose is not known at all.
  void restart(bool anywhere, Time time);

  /// How a sweep fits from the estimate.
  void watch(const ScanFit& fit, Time time);
  /// Goes on with the search, or begins one with this sweep when one is needed. X_OB: by odometry when the
  /// sweep was taken. Poses of the base at that moment, best first, on the sweep that finishes a search.
  std::vector<PoseHypothesis> search(const BeamEnds& ends, const Pose2& X_OB, Time time);
  /// The estimate is one position again.
  void found(Time time) {
    if (searching_since_) settled_since_ = time;
    searching_since_.reset();
  }
  /// Particles were put at poses found: it is open again which is right.
  void injected(Time time) { settled_since_ = time; }

  /// Since when the scan does not fit; since when the whole map is searched.
  std::optional<Time> mismatch_since() const { return mismatch_since_; }
  std::optional<Time> searching_since() const { return searching_since_; }
  /// There is no pose to hold on to: a start anywhere, or a mismatch that has lasted.
  bool pose_unknown(Time time) const {
    return searching_since_ ||
           (mismatch_since_ && time - *mismatch_since_ >= Duration::seconds(options_.kLostMismatch));
  }
  double fit() const { return fit_; }
  double w_slow() const { return w_slow_; }
  double w_fast() const { return w_fast_; }
  void move_stamps(Time time);

 private:
  bool needed(Time time) const;

  RecoveryOptions options_;
  PoseSearchOptions search_options_;
  std::optional<PoseSearch> search_;
  bool under_way_ = false;
  Pose2 X_OB_then_;
  std::optional<Time> last_end_;
  Time settled_since_;
  std::optional<Time> mismatch_since_;
  std::optional<Time> searching_since_;
  double fit_ = 0.0;
  double w_slow_ = 0.0;
  double w_fast_ = 0.0;
};

}  // namespace bw::localization
