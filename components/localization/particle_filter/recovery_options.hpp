// Parameters of finding the way back: after a start anywhere, and when the scan no longer fits.
#pragma once

#include "runtime/base/field.hpp"

namespace bw::localization {

struct RecoveryOptions {
  bool enabled = true;
  /// share of a new scan in the long average of how well scans fit; 0: off
  static constexpr double kRecoveryAlphaSlow = 0.001;
  /// share of a new scan in the short average of how well scans fit; 0: off
  static constexpr double kRecoveryAlphaFast = 0.1;
  /// a search begins when the short average falls to this share of the long one
  static constexpr double kFallenTo = 0.7;
  /// share of beams that agree with the map, of those that end at its obstacles or went through one
  static constexpr double kScanOk = 0.72;
  /// share of beams that must end in the known part of the map to judge
  static constexpr double kLeastKnown = 0.3;
  /// [s] a search begins when the mismatch has lasted so long
  static constexpr double kSearchAfter = 0.5;
  /// [s] time between the end of a search and the next one
  static constexpr double kSearchAgain = 1.0;
  /// [s] a search even while scans fit, for a place that looks alike: after as long as the pose has been
  /// settled, and every so often in the long run
  static constexpr double kVerifyEvery = 10.0;
  /// poses looked at per sweep (1000: some 0.1 ms)
  static constexpr int kSearchNodes = 20000;
  /// a pose found counts if the share that agrees is so much higher there
  static constexpr double kBetterBy = 0.05;
  /// weight that the poses found get together while no pose is known (set by code alone)
  double share = 0.5;
  /// the same while there is one: the scans that follow must speak for them
  static constexpr double kRivalShare = 0.02;
  /// [m] spread of the particles about a pose found: position
  static constexpr double kSigma = 0.1;
  /// [rad] spread of the particles about a pose found: heading (set by code alone)
  double heading_sigma = 0.05;
  /// [s] LOST when the scan has not fitted for so long
  static constexpr double kLostMismatch = 2.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("enabled", enabled,
      {.doc = "search the whole map when the scan does not fit, or after a start anywhere"});
  }
};

}  // namespace bw::localization
