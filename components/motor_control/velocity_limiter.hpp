// Turns commanded twists into twists the base can follow: bounded speed, acceleration and jerk, and a stop
// when the command is unusable.
//
// Saturation scales v and omega together, so the curvature omega / v of the command stays (model/README.md
// 2.1). Linear speed then approaches the command with the largest acceleration a' that can still be taken
// back by the jerk limit j before the command is passed:
//
//   v + a' dt + a' |a'| / (2 j) = command   =>   |a'| = 2 |e| / (dt + sqrt(dt^2 + 2 |e| / j))
//   with e = command - v
//
// clipped to |a'| <= acc_max and |a' - a| <= j dt. The turn rate approaches with alpha_max, within what the
// wheels have left. While a safety function slows the robot down, |v| and |omega| fall without jerk limit and
// as fast as the faster wheel can with stop_deceleration, both in proportion, so that the curvature stays
// (components/model/stopping.hpp).
#pragma once

#include <optional>
#include <string_view>

#include "components/model/differential_drive.hpp"
#include "components/model/robot.hpp"
#include "runtime/base/time.hpp"

namespace bw {

struct LimiterOptions {
  double command_timeout = 0.2;
  /// a command beyond this many times the limits is a fault, not a wish: the robot stops (set by code alone)
  double plausible_factor = 10.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("command_timeout", command_timeout,
      {.unit = "s",
       .min = 0.02,
       .max = 1,
       .doc = "oldest usable command; raise it for slow or remote planners"});
    v.retired({"plausible_factor"}, "a constant of velocity_limiter.hpp");
  }
};

enum class LimiterState {
  waiting,      ///< no command yet, or none since the clock went back
  following,    ///< the command is fresh and sound
  stale,        ///< the newest command is older than command_timeout: safety stop
  not_finite,   ///< it holds NaN or infinity: safety stop
  implausible,  ///< it lies far beyond the limits: safety stop
  told_to       ///< stop() was called: safety stop
};

/// One sentence for people.
std::string_view describe(LimiterState state);

enum class Braking {
  smooth,  ///< within acc_max and jerk_max
  hard,    ///< with stop_deceleration: a safety function limits the command
};

struct LimitedTwist {
  Twist2 twist;
  LimiterState state = LimiterState::waiting;
};

/// Times are of the component clock: the moment a command arrived, not its stamp.
class VelocityLimiter {
 public:
  VelocityLimiter(const Robot& robot, const LimiterOptions& options);

  void set_options(const LimiterOptions& options) {
    timeout_ = Duration::seconds(options.command_timeout);
    plausible_factor_ = options.plausible_factor;
  }

  void command(Time now, const Twist2& twist);
  /// Speeds that commands are cut to from now on, at most the robot's own; they are reached within acc_max
  /// and jerk_max.
  void allow(const Limits& limits) { allowed_ = limits; }
  /// How lower speeds are reached, until told otherwise.
  void set_braking(Braking braking) { braking_ = braking; }
  /// The twist from now until the next step. Call at a steady rate.
  LimitedTwist step(Time now);
  /// Like step(), but brakes with stop_deceleration whatever the command is.
  LimitedTwist stop(Time now);
  /// The robot stands by other means: the next step begins at rest, and needs a command that arrives from now
  /// on.
  void rest();

 private:
  double elapsed(Time now);
  LimiterState judge(Time now) const;
  void follow(const Twist2& wish, double dt);
  void approach(double wish, double dt);
  void brake_towards(double wish, double loss);
  void brake_to_rest(double dt);

  Limits limits_;   ///< of the robot: what a sound command stays near to
  Limits allowed_;  ///< at present
  double half_separation_;
  double wheel_speed_max_;
  Duration timeout_;
  double plausible_factor_;

  std::optional<Time> arrival_;
  Twist2 command_;
  Braking braking_ = Braking::smooth;
  std::optional<Time> last_step_;
  Twist2 twist_;               ///< given out last
  double acceleration_ = 0.0;  ///< of the last step, linear
};

/// The nearest twist of the same curvature and direction within the speed limits of body and wheels.
Twist2 saturate(const Twist2& twist, const Limits& limits, double wheel_separation, double wheel_speed_max);

}  // namespace bw
