// Where the odometry said the robot was, for as long as a sweep may be old.
#pragma once

#include <algorithm>
#include <deque>

#include "components/model/differential_drive.hpp"
#include "components/model/sweep_motion.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw::safety {

class PoseHistory {
 public:
  /// A clock that goes back begins it anew.
  void add(Time time, const Pose2& X_OB, const Twist2& twist) {
    if (!poses_.empty() && time < poses_.back().time) poses_.clear();
    if (!poses_.empty() && time == poses_.back().time) poses_.pop_back();
    poses_.push_back({time, X_OB, twist});
    while (poses_.front().time + kLength < time || poses_.size() > kMax) poses_.pop_front();
  }
  bool is_empty() const { return poses_.empty(); }

  /// Between two poses by one body velocity, beyond them by the twist, for 0.3 s at the most.
  Pose2 at(Time time) const {
    if (poses_.empty()) return {};
    const auto after = std::ranges::lower_bound(poses_, time, {}, &Entry::time);
    if (after != poses_.begin() && after != poses_.end()) {
      const Entry& before = *(after - 1);
      const double share = (time - before.time).to_seconds() / (after->time - before.time).to_seconds();
      return pose_between(before.X_OB, after->X_OB, share);
    }
    const Entry& nearest = after == poses_.end() ? poses_.back() : poses_.front();
    return advance_exact(nearest.X_OB, nearest.twist,
                         std::clamp((time - nearest.time).to_seconds(), -kBeyond, kBeyond));
  }

 private:
  static constexpr Duration kLength = Duration::milliseconds(5'500);
  static constexpr std::size_t kMax = 2'000;
  static constexpr double kBeyond = 0.3;  // [s]

  struct Entry {
    Time time;
    Pose2 X_OB;
    Twist2 twist;
  };
  std::deque<Entry> poses_;
};

}  // namespace bw::safety
