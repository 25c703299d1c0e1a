// Everything that may keep a base from obeying, the same for all drivers: the age of commands, touches,
// wheels that do otherwise, the cable, the battery, the emergency stop. Values in, wheel speeds and the
// reason out; a driver decides nothing.
//
// What forbids to drive makes a ramp to rest with `stop_deceleration`; a touch, a cliff, a dropped wheel and
// a device that was opened anew make it zero at once. When nothing forbids it any more it stands for
// `restart.pause` and says so; then a command is needed that arrived after that.
#pragma once

#include <optional>
#include <string>

#include "components/robot_base/base_condition.hpp"
#include "components/robot_base/battery_guard.hpp"
#include "components/robot_base/contact_reaction.hpp"
#include "components/robot_base/link_guard.hpp"
#include "components/robot_base/readings.hpp"
#include "components/robot_base/stop_latch.hpp"
#include "components/robot_base/wheel_guard.hpp"
#include "components/robot_base/wheel_watchdog.hpp"

namespace bw {

struct BaseGuardOptions {
  WatchdogOptions watchdog;
  LinkOptions link;
  ContactOptions contacts;
  WheelGuardOptions wheels;
  BatteryOptions battery;
  StopOptions restart;

  template <class Visitor>
  void fields(Visitor& v) {
    v("watchdog", watchdog, {.doc = "the stop when wheel commands stop"});
    v("link", link, {.doc = "the stop when the base is not heard"});
    v("contacts", contacts, {.doc = "what bumpers and cliff sensors make it do"});
    v("wheels", wheels, {.doc = "stall and runaway: wheels that turn otherwise than told"});
    v("battery", battery, {.doc = "limits of the voltage"});
    v("restart", restart, {.doc = "what it takes until it drives again"});
  }
};

struct BaseOutput {
  WheelSpeeds wheels;  ///< for the driver
  BaseCondition condition = BaseCondition::waiting;
  bool is_latched = false;  ///< it takes a release
  std::string reason;       ///< for people; empty while it drives or waits for commands
  WatchdogState commands = WatchdogState::waiting;
  bool operator==(const BaseOutput&) const = default;
};

/// Times are of the component clock.
class BaseGuard {
 public:
  /// `response` [s]: of the driver's BaseFacts.
  BaseGuard(const BaseGuardOptions& options, const Robot& robot, double response);

  /// False: it is not finite, and refused.
  bool command(Time now, const WheelSpeeds& wheels);
  /// It takes the place of one that was killed, maybe while it drove: as a link that is lost for its first `restart.pause`.
  void takes_over() { takes_over_ = true; }
  /// Commands may not be trusted now: the newest one is dropped.
  void revoke() { watchdog_.revoke(); }
  void set_emergency_stop(bool is_on, const std::string& reason = "the emergency stop is pressed");
  /// What the driver told at a poll, but for how the wheels moved.
  void read(Time now, const Readings& readings);
  /// Sound travel of the wheels until `stamp`.
  void moved(Time stamp, const WheelTravel& travel);
  /// What the wheels shall do from `now` on. Every 10 ms, and when something came.
  BaseOutput step(Time now);
  /// What the driver was given, and whether it got through.
  void told(Time now, const WheelSpeeds& wheels, bool is_through);
  /// The deliberate reset; says why not. Nothing moves for `restart.pause` from then on.
  std::optional<std::string> release();

  BatteryLevel battery() const { return battery_.level(); }
  const ContactReading& contacts() const { return contacts_; }
  std::uint64_t timeouts() const { return watchdog_.timeouts(); }

 private:
  friend struct GuardState;  ///< of tests: what decides what it does next
  void read_contacts(Time now, const ContactReading& contacts);
  bool wants_motion(Time now) const;
  BaseOutput decide(Time now, LinkHealth health);
  BaseOutput stand(Time now, StopCause cause, bool is_reopened);
  BaseOutput pause(Time now);
  bool may_back_off() const;
  WheelSpeeds braked(Time now) const;

  double stop_deceleration_;
  Duration pause_, timeout_, silence_;
  WheelWatchdog watchdog_;
  LinkGuard link_;
  ContactReaction reaction_;
  WheelGuard wheels_;
  BatteryGuard battery_;
  StopLatch latch_;
  ContactReading contacts_;
  std::string overcurrent_;
  double travelled_ = 0.0;  ///< forward, in sum [m]
  BaseOutput output_;
  Duration pause_left_;
  std::optional<Time> wished_;  ///< the newest command, if it wants motion
  std::optional<Time> last_step_;
  bool takes_over_ = false;
  std::optional<Time> first_step_;
};

}  // namespace bw
