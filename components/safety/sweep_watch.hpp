// Whether the laser can be trusted now: sweeps keep coming, are sound, and change while the robot moves.
//
// A sweep that is not sound or whose ranges are those of the last one although the robot has moved is not
// fresh. Without a fresh sweep for source_timeout the laser counts as lost.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "components/model/laser_sweep.hpp"

namespace bw::safety {

enum class LaserState {
  waiting,  ///< no fresh sweep yet
  ok,
  silent,   ///< sweeps stopped coming
  frozen,   ///< the same ranges again and again while the robot moved
  invalid,  ///< sweeps come, but are not sound
};

class SweepWatch {
 public:
  explicit SweepWatch(Duration timeout) : timeout_(timeout) {}

  /// A sweep that arrived at `now` with stamp `measured_at`, `fault` by check_sweep; X_OB: where the robot
  /// is. True when it is fresh.
  bool add(Time now, Time measured_at, std::span<const float> ranges, SweepFault fault, const Pose2& X_OB);

  /// The clock went back to `now`: what came before is not fresh, and no later than what comes.
  void forget(Time now);
  LaserState state(Time now) const;

 private:
  Duration timeout_;
  std::optional<Time> fresh_at_;
  LaserState last_ = LaserState::waiting;  ///< what was wrong with the newest sweep; ok: nothing
  std::optional<Time> arrived_at_;
  std::optional<Time> stamp_;
  std::vector<float> ranges_;
  Pose2 X_OB_;  ///< when these ranges came first
};

}  // namespace bw::safety
