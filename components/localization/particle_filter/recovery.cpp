#include "components/localization/particle_filter/recovery.hpp"

#include <algorithm>

namespace bw::localization {

Recovery::Recovery(const RecoveryOptions& options, const PoseSearchOptions& search)
    : options_(options), search_options_(search) {}

void Recovery::set_field(const LikelihoodField& field) {
  search_.reset();
  if (options_.enabled) search_.emplace(field, search_options_);
  under_way_ = false;
  w_slow_ = w_fast_ = 0.0;
}

void Recovery::restart(bool anywhere, Time time) {
  under_way_ = false;
  last_end_.reset();
  settled_since_ = time;
  mismatch_since_.reset();
  searching_since_.reset();
  if (anywhere) searching_since_ = time;
  w_slow_ = w_fast_ = 0.0;
}

void Recovery::move_stamps(Time time) {
  under_way_ = false;
  last_end_.reset();
  settled_since_ = time;
  if (mismatch_since_) mismatch_since_ = time;
  if (searching_since_) searching_since_ = time;
}

void Recovery::watch(const ScanFit& fit, Time time) {
  if (fit.known < options_.kLeastKnown) return;
  fit_ = fit.agreement();
  if (!searching_since_) {  // before, there is no place that a scan could fit from
    if (w_slow_ == 0.0) w_slow_ = w_fast_ = fit_;
    w_slow_ += options_.kRecoveryAlphaSlow * (fit_ - w_slow_);
    w_fast_ += options_.kRecoveryAlphaFast * (fit_ - w_fast_);
  }
  if (fit_ >= options_.kScanOk) {
    mismatch_since_.reset();
  } else if (!mismatch_since_) {
    mismatch_since_ = time;
  }
}

bool Recovery::needed(Time time) const {
  if (last_end_ && time - *last_end_ < Duration::seconds(options_.kSearchAgain)) return false;
  if (searching_since_) return true;
  if (mismatch_since_ && time - *mismatch_since_ >= Duration::seconds(options_.kSearchAfter)) return true;
  // A place may look like another for a while: the longer the pose has held, the less often that is asked.
  const Time last = last_end_.value_or(settled_since_);
  const Duration settled = last - settled_since_;
  const Duration pause =
      std::clamp(settled, Duration::seconds(options_.kSearchAgain), Duration::seconds(options_.kVerifyEvery));
  if (time - last >= pause) return true;
  const double low =
      options_.kFallenTo * w_slow_;  // and still there: the short average takes its time to rise
  return options_.kRecoveryAlphaSlow > 0.0 && w_fast_ < low && fit_ < low;
}

std::vector<PoseHypothesis> Recovery::search(const BeamEnds& ends, const Pose2& X_OB, Time time) {
  if (!search_) return {};
  if (!under_way_) {
    if (!needed(time)) return {};
    search_->begin(ends);
    X_OB_then_ = X_OB;
    under_way_ = true;
  }
  if (!search_->advance(options_.kSearchNodes)) return {};
  under_way_ = false;
  last_end_ = time;
  const Pose2 moved = inverse(X_OB_then_) * X_OB;
  std::vector<PoseHypothesis> poses = search_->results();
  for (PoseHypothesis& pose : poses) pose.X_MB = pose.X_MB * moved;
  return poses;
}

}  // namespace bw::localization
