// Odometry of the last seconds, asked for at the times of scans.
#pragma once

#include <deque>
#include <optional>

#include "components/model/sweep_motion.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw::slam {

class OdometryHistory {
 public:
  static constexpr double kKept = 5.0;     ///< [s]
  static constexpr double kLongest = 1.0;  ///< [s] between two poses over which one is interpolated

  /// In order of time; a clock that goes back begins anew. False: it did.
  bool add(Time time, const Pose2& X_OB) {
    const bool in_order = poses_.empty() || time >= poses_.back().time;
    if (!in_order) poses_.clear();
    poses_.push_back({time, X_OB});
    while ((time - poses_.front().time).to_seconds() > kKept) poses_.pop_front();
    return in_order;
  }

  bool covers(Time time) const { return !poses_.empty() && poses_.back().time >= time; }
  bool began_after(Time time) const { return !poses_.empty() && poses_.front().time > time; }
  std::optional<Time> newest() const {
    return poses_.empty() ? std::nullopt : std::optional(poses_.back().time);
  }

  /// X_OB; nothing outside of what is kept, or in a gap.
  std::optional<Pose2> at(Time time) const {
    for (std::size_t i = poses_.size(); i-- > 0;) {
      if (poses_[i].time > time) continue;
      if (poses_[i].time == time) return poses_[i].X_OB;
      if (i + 1 == poses_.size()) return std::nullopt;
      const double gap = (poses_[i + 1].time - poses_[i].time).to_seconds();
      if (gap > kLongest) return std::nullopt;
      return pose_between(poses_[i].X_OB, poses_[i + 1].X_OB, (time - poses_[i].time).to_seconds() / gap);
    }
    return std::nullopt;
  }

 private:
  struct Stamped {
    Time time;
    Pose2 X_OB;
  };
  std::deque<Stamped> poses_;
};

}  // namespace bw::slam
