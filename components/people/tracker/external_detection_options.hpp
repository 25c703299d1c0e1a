// Parameters of what other detectors tell.
#pragma once

namespace bw::people {

struct ExternalDetectionOptions {
  /// [m] standard deviation of the places that other detectors tell, along each axis
  static constexpr double kPositionDeviation = 0.2;
  /// share of a reliability that one message counts for: belief b becomes
  /// 1 - (1 - b) (1 - kTrust reliability); 0.5 is a confirmed person
  static constexpr double kTrust = 0.4;
  /// [s] belief that is not repeated fades with this time constant
  static constexpr double kMemory = 2.0;
  /// [s] of whom a laser saw within this time the place is the laser's alone
  static constexpr double kSeen = 0.3;
  /// least score of what stands where somebody is told to be, to be a leg of theirs
  static constexpr double kLegScore = 0.3;
  /// most belief in somebody where a laser has seen nothing for death.unseen; below 0.5: no confirmed person
  static constexpr double kUnseenLimit = 0.45;
  /// [m/s] standard deviation of a velocity that is told, and of one that is not, per axis
  static constexpr double kToldSpeed = 0.5;
  static constexpr double kUntoldSpeed = 1.0;
  /// [s] whom somebody told of within this time is not let go
  static constexpr double kTold = 1.0;
  /// whom no laser sees is gone when the belief has sunk to this
  static constexpr double kForgotten = 0.2;
};

}  // namespace bw::people
