// Whether the wheels do what they are told, by their own encoders. Each wheel has a band of speeds [lo, hi]
// in which it may be: all that was commanded within the last `response` seconds, since a base answers late,
// and what it can have reached from there:
//
//   hi = highest command in [t - response, t], but falls no faster than the base brakes or accelerates; lo
//   likewise below <- max(0, below + lo dt - ds - m dt),  above <- max(0, above + ds - hi dt - m dt),  m =
//   share max(|lo|, |hi|) + tolerance
//
// with ds the travel between two readings dt apart. Either sum beyond slack + 2 ticks is an alarm: the sum of
// the readings' errors is never more than 2 ticks, however coarse they are, so the resolution costs time and
// no false alarm. A wheel that stands though its command is a steady v is found after
//
//   (slack + 2 ticks) / ((1 - share) |v| - tolerance)      and the age of a reading
//
// which for ticks of 0.1 mm is 62 ms at 0.17 m/s and 0.2 s at 0.07 m/s, for ticks of 3.3 mm 0.2 s at 0.12
// m/s; one that is told to set off, `response` later. Slip is invisible here: wheels rotate as told.
#pragma once

#include <array>
#include <deque>
#include <string>

#include "components/model/differential_drive.hpp"
#include "components/model/robot.hpp"
#include "components/robot_base/encoder_odometry.hpp"
#include "runtime/base/field.hpp"
#include "runtime/base/time.hpp"

namespace bw {

struct WheelGuardOptions {
  double share = 0.3;
  /// [m/s] and this much off, as when it is pushed by hand (set by code alone)
  double tolerance = 0.02;
  /// [m] distance that a wheel may be behind or ahead beyond that, and two encoder ticks (set by code alone)
  double slack = 0.006;

  template <class Visitor>
  void fields(Visitor& v) {
    v("share", share,
      {.min = 0.05, .max = 1, .doc = "a wheel may be this share of its speed off; raise it for weak motors"});
  }
};

enum class WheelVerdict {
  sound,
  stall,   ///< slower than told, or standing
  runaway  ///< faster than told, or the other way
};

class WheelGuard {
 public:
  /// `response` [s]: from a command to the readings that show it, at most.
  WheelGuard(const WheelGuardOptions& options, const Robot& robot, double response);

  /// What the driver was given at `now`; it holds until the next.
  void commanded(Time now, const WheelSpeeds& wheels);
  /// The wheels rotated so far until `stamp`.
  WheelVerdict measured(Time stamp, const WheelTravel& travel);
  /// Forgets what it knows of the wheels: it looks anew from the next reading on, whatever they do then.
  void reset();
  /// Of the last alarm, for people.
  const std::string& reason() const { return reason_; }

 private:
  friend struct GuardState;  ///< of tests: what decides what it does next
  struct Side {
    bool is_known = false;
    double lo = 0.0, hi = 0.0;             ///< [m/s]
    double below = 0.0, above = 0.0;       ///< [m]
    double seconds = 0.0, distance = 0.0;  ///< since either sum left zero
  };
  struct Command {
    Time time;
    std::array<double, 2> wheels;
  };
  void follow(Side& side, double lowest, double highest, double dt) const;
  bool is_off(Side& side, double distance, double dt) const;
  WheelVerdict judge(const Side& side, const char* name);

  WheelGuardOptions options_;
  Duration response_;
  double acceleration_, deceleration_;
  double resolution_;  ///< of a distance between two readings [m]
  double limit_;       ///< [m]
  std::deque<Command> commands_;
  std::array<Side, 2> sides_;
  std::string reason_;
};

}  // namespace bw
