// Who stands shifts a foot now and then; a post does not. Kept for each leg.
#pragma once

#include "runtime/base/pose2.hpp"

namespace bw::people {

/// Looks for a place that stays, changes by a few centimetres and stays again: the place of a leg while the laser
/// stands still, or the way from one leg to the other, which a laser that moves sees as well. All the time it is seen
/// from about the same side: another one, or something in front of it, moves the middle of anything.
class Fidgets {
 public:
  static constexpr double kEach = 4.0;  ///< log odds of one shift
  static constexpr double kMost = 8.0;

  /// `whole`: nothing hides an edge; `bearing` along which it is seen [rad], which may turn by `turn`.
  void add(double time, const Vector2& place, bool whole, double bearing, double turn);

  double log_odds() const;

 private:
  void stand_anew(double time, const Vector2& place, double bearing);

  Vector2 stood_{0.0, 0.0};  ///< where, on average
  Vector2 moved_{0.0, 0.0};  ///< where it seems to be now
  double since_ = 0.0;       ///< it stands there [s]
  double aside_ = -1.0;      ///< since when it has been off that place [s]; < 0: it is not
  double last_ = 0.0;
  double bearing_ = 0.0;
  int count_ = 0;  ///< sightings that made up the mean, bounded
  int moved_count_ = 0;
  int shifts_ = 0;
};

}  // namespace bw::people
