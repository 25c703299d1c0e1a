// Why the base has to stand, and what it takes until it may drive again: a release by somebody who means it,
// or that the cause is over. An emergency stop, and by default all that touched, fell, blocked or ran by
// itself, needs the release, and so does what interrupted a goal or a hand: nobody shall be surprised by a
// robot that drives off after they lifted it, freed it, pulled its charger or put its cable in again (ISO
// 3691-4 bars the automatic restart).
#pragma once

#include <array>
#include <optional>
#include <string>

#include "components/robot_base/base_condition.hpp"
#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw {

enum class Restart {
  released,   ///< only by release_stop
  if_idle,    ///< by itself if nobody wanted motion from its beginning to its end, else only by release_stop
  by_itself,  ///< when the cause is over
};

constexpr auto choice_table(Restart) {
  return choices<Restart>(
      {{Restart::released, "released"}, {Restart::if_idle, "if_idle"}, {Restart::by_itself, "by_itself"}});
}

struct StopOptions {
  /// after a wheel hung in the air: somebody looks where it stands (set by code alone)
  Restart wheel_drop = Restart::released;
  /// after a cliff sensor saw no floor, likewise (set by code alone)
  Restart cliff = Restart::released;
  Restart bumper = Restart::released;
  /// after wheels rotated otherwise than they were told: they would again (set by code alone)
  Restart runaway = Restart::released;
  /// after wheels lagged behind or stood though they were told to rotate, likewise (set by code alone)
  Restart stall = Restart::released;
  Restart link = Restart::if_idle;
  Restart device = Restart::if_idle;
  /// after the battery was empty: its voltage recovers without a charger (set by code alone)
  Restart battery = Restart::released;
  Restart charging = Restart::if_idle;
  double pause = 2.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("bumper", bumper, {.doc = "restart after a bumper touched something"});
    v("link", link, {.doc = "restart after the base was not heard"});
    v("device", device, {.doc = "restart after the base, or its driver, told of a fault"});
    v("charging", charging, {.doc = "restart after the charger was connected"});
    v("pause", pause,
      {.unit = "s",
       .min = 0.5,
       .max = 60,
       .doc = "so long it stands after a release, or after the last cause is over, and says so"});
    v.retired({"wheel_drop", "cliff", "runaway", "stall", "battery"}, "always released, by stop_latch.hpp");
  }

  Restart of(StopCause cause) const;
};

class StopLatch {
 public:
  explicit StopLatch(const StopOptions& options) : options_(options) {}

  /// Whether the cause is there; `reason` is for people.
  void set(StopCause cause, bool is_present, const std::string& reason = {});
  /// What happened once, and is not there longer than that: it holds until let_go() at least.
  void strike(StopCause cause, const std::string& reason) {
    set(cause, true, reason);
    set(cause, false);
  }
  /// Somebody wants motion now: all that holds interrupts it.
  void interrupt();
  /// Of all that is over and takes no release.
  void let_go();
  /// The gravest cause that holds; nothing: the base may drive.
  std::optional<StopCause> holds() const;
  bool holds(StopCause cause) const { return at(cause).holds; }
  /// Whether it takes a release: of the gravest cause, or of another that holds.
  bool is_latched() const;
  const std::string& reason(StopCause cause) const { return at(cause).reason; }
  /// The deliberate reset of all. Says why not while a cause lasts that needs it, and lets go of nothing
  /// then.
  std::optional<std::string> release();

 private:
  friend struct GuardState;  ///< of tests: what decides what it does next
  struct Held {
    bool is_present = false;
    bool holds = false;
    bool has_interrupted = false;
    std::string reason;
  };
  const Held& at(StopCause cause) const { return held_[static_cast<std::size_t>(cause)]; }
  bool is_latched(StopCause cause) const;

  StopOptions options_;
  std::array<Held, kStopCauses> held_;
};

}  // namespace bw
