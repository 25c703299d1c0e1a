// Whether a laser that sees nothing can be believed. By REP 117 a beam of +inf says that nothing is in reach:
// in an open place whole sweeps do. A laser whose light fails, or that somebody covers, says the same.
//
// What was seen tells them apart. Things leave a laser's sight by the end of its range, or by the edges of
// its field, a few at a time; they do not vanish from its middle between two sweeps. After a sweep with many
// returns there, one that hits nothing is a fault, and stays one until something is hit again or somebody
// says that the place is open. A laser that has seen nothing yet is believed.
//
// Of a part of the field the same, point by point: one that was hit for half a second at the same spot
// stands, and may be hidden, but not gone, however slowly a cover grows; one that was not may have walked up
// to 0.3 rad aside. As many as appear anew within 0.3 rad are those that moved. Where more are gone, free
// beams are dark, until something is hit there again, or the point has left the middle of the field or its
// range.
//
// Odometry errs meanwhile, and turns what stood past the end of a wall, where beams are free. So all points
// follow the surfaces that are still hit: a cover hides hits, and moves none. What odometry errs along walls
// that are all parallel stays; narrow things tell nothing, as they may walk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "components/safety/sweep.hpp"
#include "components/safety/sweep_options.hpp"
#include "runtime/base/time.hpp"

namespace bw::safety {

class EmptySight {
 public:
  explicit EmptySight(const SweepOptions& options) : min_returns_(options.min_returns) {}

  /// `checked` is what check_sweep made of `sweep`, without fault, and X_OB where the robot was then. False:
  /// it hits less than min_returns although something that the last believed sweep saw must still be there.
  /// Else the free beams of `checked` that cannot be believed are dark.
  bool believes(const LaserSweep& sweep, const Pose2& X_OB, CheckedSweep& checked);
  /// What was seen counts no more: the next empty sweep is believed.
  void forget() { points_.clear(); }
  /// Whether any sweep had returns.
  bool has_seen() const { return has_seen_; }

 private:
  std::int64_t min_returns_;
  /// Of a point that the next sweep must still show.
  struct TrackedPoint {
    Vector2 position{0.0, 0.0};   ///< in odom as it is now
    std::size_t beam = 0;         ///< of the newest sweep, that looks there
    Time since;                   ///< hit there
    bool is_narrow = false;       ///< of a thing that may walk
    std::optional<Time> lost_at;  ///< where free beams are now
    bool is_missed = false;       ///< with so many that something was there
  };
  class Memory;

  std::vector<TrackedPoint> points_;
  bool has_seen_ = false;
};

}  // namespace bw::safety
