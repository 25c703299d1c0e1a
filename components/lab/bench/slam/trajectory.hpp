// Poses of a replayed drive at any stamp: those of the scans, and between them.
#pragma once

#include <optional>
#include <vector>

#include "components/slam/drive_replay.hpp"

namespace bw::slam {

enum class Told {
  at_the_end,   ///< after the last optimisation
  at_the_time,  ///< when the scan came
  by_odometry,  ///< alone, in odom
};

class Trajectory {
 public:
  /// Of both, which outlive this.
  Trajectory(const SlamReplay& replayed, const std::vector<OdometrySample>& odometry, Told told);

  /// Of the scan at `time`, if there is one within kSameStamp; else between two scans that are no longer
  /// apart than kShortGap; else from the nearest one on by odometry. Nothing where that is farther than
  /// kFarthest, or odometry does not know both.
  std::optional<Pose2> at(Time time) const;
  /// Of the scan at `time` alone.
  std::optional<Pose2> of_scan(Time time) const;

  static constexpr Duration kSameStamp{20'000};  ///< stamps of relations may be rounded to 10 us
  static constexpr Duration kShortGap = Duration::milliseconds(1000);
  static constexpr Duration kFarthest = Duration::milliseconds(10'000);

 private:
  const SlamReplay& replayed_;
  const std::vector<OdometrySample>& odometry_;
  std::vector<Pose2> poses_;
};

}  // namespace bw::slam
