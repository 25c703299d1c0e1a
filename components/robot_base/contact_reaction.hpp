// What the base does about a touch, a missing floor or a wheel in the air, since no firmware does it: a
// bumper or a cliff sensor in front makes it back off, slowly and a little, then it stands. A dropped wheel
// makes it stand at once, also while it backs off: that is how a cliff behind, which no sensor sees, is
// noticed. A base that stood when it was touched goes on standing.
//
// Backing off is straight, along the path it came, and measured by the wheels. It ends early enough that the
// base stands within `distance`: v (t_lag + v / 2 a) before, t_lag = 0.05 s from the command until the wheels
// slow down. What else is touched meanwhile makes it no longer. It is none of the planner's back-offs, and
// stands below them: it sees no obstacle and asks no planner, since whoever drove into what was touched did
// not see it either.
#pragma once

#include <optional>

#include "components/model/differential_drive.hpp"
#include "components/robot_base/readings.hpp"
#include "runtime/base/field.hpp"
#include "runtime/base/time.hpp"

namespace bw {

struct ContactOptions {
  bool back_off = true;
  /// [m/s] of backing off: it ends within 2.5 mm of the command to stand, with 2 m/s^2
  static constexpr double kSpeed = 0.1;
  double distance = 0.15;
  /// [s] it backs off this long at most, if wheels do not rotate (set by code alone)
  double time_limit = 3.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("back_off", back_off, {.doc = "false: a bumper or cliff makes it stand, and no more"});
    v("distance", distance,
      {.unit = "m",
       .min = 0.02,
       .max = 0.5,
       .doc = "it backs off this far at most; nothing looks behind it"});
    v.retired({"speed"}, "a constant of contact_reaction.hpp");
  }
};

class ContactReaction {
 public:
  ContactReaction(const ContactOptions& options, double stop_deceleration)
      : options_(options), stop_deceleration_(stop_deceleration) {}

  /// A touch began at `now`, while the wheels had gone `travelled` [m] forward in sum.
  void touch(Time now, double travelled, const ContactReading& contacts, bool is_driving);
  /// Ends it: something else forbids to move.
  void end() { since_.reset(); }
  /// Where the wheels shall rotate; nothing when it does not back off.
  std::optional<WheelSpeeds> step(Time now, double travelled, const ContactReading& contacts);
  bool is_backing_off() const { return since_.has_value(); }

 private:
  friend struct GuardState;  ///< of tests: what decides what it does next
  ContactOptions options_;
  double stop_deceleration_;
  std::optional<Time> since_;
  double from_ = 0.0;
};

}  // namespace bw
