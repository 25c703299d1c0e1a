// Parameters of finding the way back: after a start anywhere, and when the scan no longer fits.
#pragma once

#include "runtime/base/field.hpp"

namespace bw::localization {

struct RecoveryOptions {
  bool enabled = true;
  double recovery_alpha_slow = 0.001;
  double recovery_alpha_fast = 0.1;
  /// a search begins when the short average falls to this share of the long one
  static constexpr double kFallenTo = 0.7;
  double scan_ok = 0.72;
  /// share of beams that must end in the known part of the map to judge
  static constexpr double kLeastKnown = 0.3;
  double search_after = 0.5;
  double search_again = 1.0;
  /// [s] a search even while scans fit, for a place that looks alike: after as long as the pose has been
  /// settled, and every so often in the long run
  static constexpr double kVerifyEvery = 10.0;
  int search_nodes = 20000;
  /// a pose found counts if the share that agrees is so much higher there
  static constexpr double kBetterBy = 0.05;
  double share = 0.5;
  /// the same while there is one: the scans that follow must speak for them
  static constexpr double kRivalShare = 0.02;
  double sigma = 0.1;
  double heading_sigma = 0.05;
  double lost_mismatch = 2.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("enabled", enabled,
      {.doc = "search the whole map when the scan does not fit, or after a start anywhere"});
    v("recovery_alpha_slow", recovery_alpha_slow,
      {.min = 0, .max = 1, .doc = "share of a new scan in the long average of how well scans fit; 0: off"});
    v("recovery_alpha_fast", recovery_alpha_fast,
      {.min = 0, .max = 1, .doc = "share of a new scan in the short average of how well scans fit; 0: off"});
    v("scan_ok", scan_ok,
      {.min = 0,
       .max = 1,
       .doc =
           "share of beams that agree with the map, of those that end at its obstacles or went through one; "
           "less is a mismatch"});
    v("search_after", search_after,
      {.unit = "s", .min = 0, .max = 100, .doc = "a search begins when the mismatch has lasted so long"});
    v("search_again", search_again,
      {.unit = "s", .min = 0, .max = 100, .doc = "time between the end of a search and the next one"});
    v("search_nodes", search_nodes,
      {.min = 100,
       .max = 10000000,
       .doc = "poses looked at per sweep (1000: some 0.1 ms); more finds earlier"});
    v("share", share,
      {.min = 0.01, .max = 0.99, .doc = "weight that the poses found get together while no pose is known"});
    v("sigma", sigma,
      {.unit = "m", .min = 0.001, .max = 5, .doc = "spread of the particles about a pose found: position"});
    v("heading_sigma", heading_sigma,
      {.unit = "rad", .min = 0.001, .max = 3, .doc = "spread of the particles about a pose found: heading"});
    v("lost_mismatch", lost_mismatch,
      {.unit = "s", .min = 0.1, .max = 100, .doc = "LOST when the scan has not fitted for so long"});
  }
};

}  // namespace bw::localization
