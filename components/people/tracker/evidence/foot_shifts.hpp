// Who stands shifts a foot now and then; a post does not. Kept for each leg.
#pragma once

#include "runtime/base/pose2.hpp"

namespace bw::people {

/// Looks for a position that stays, changes by a few centimetres and stays again: the position of a leg while
/// the laser stands still, or the offset from one leg to the other, which a laser that moves sees as well.
/// All the time it is seen from about the same side: another one, or something in front of it, moves the
/// middle of anything.
class FootShifts {
 public:
  static constexpr double kEach = 4.0;  ///< log odds of one shift
  static constexpr double kMax = 8.0;

  /// What ends the memory of where it stood: a time unseen [s], and a rotation of the line of sight [rad].
  struct Memory {
    double gap;
    double bearing_change;
  };

  /// `whole`: nothing hides an edge; `bearing` along which it is seen [rad].
  void add(double time, const Vector2& position, bool whole, double bearing, const Memory& memory);

  /// Where it stands; zero at first.
  const Vector2& position() const { return stood_; }

  double log_odds() const;

 private:
  void stand_anew(const Vector2& position, double bearing, double stood_for);

  Vector2 stood_{0.0, 0.0};  ///< where, on average
  Vector2 moved_{0.0, 0.0};  ///< where it seems to be now
  double stood_for_ = 0.0;   ///< in view [s]
  double moved_for_ = 0.0;   ///< the same of where it seems to be now [s]
  bool aside_ = false;       ///< it is off the position where it stood
  double last_ = 0.0;
  double bearing_ = 0.0;
  int count_ = 0;  ///< sightings that made up the mean, bounded
  int moved_count_ = 0;
  int shifts_ = 0;
};

}  // namespace bw::people
