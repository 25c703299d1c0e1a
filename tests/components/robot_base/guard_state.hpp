// All that decides what a guard does from now on, as text: times as ages, distances as what is left. What is
// older than any of its limits is as good as one age. Counters, and texts for people, are left out.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "components/robot_base/base_guard.hpp"

namespace bw {

struct GuardState {
  static std::string of(const BaseGuard& guard, Time now) {
    GuardState state{now, {}};
    state.add(guard.watchdog_);
    state.add(guard.link_);
    state.add(guard.reaction_, guard.travelled_);
    state.add(guard.wheels_);
    state.add(guard.battery_);
    for (const StopLatch::Held& held : guard.latch_.held_)
      state.add((held.is_present ? 1 : 0) + (held.holds ? 2 : 0) + (held.has_interrupted ? 4 : 0));
    state.add(guard.contacts_);
    state.add(guard.overcurrent_.empty() ? 0 : 1);
    state.add(guard.output_.wheels);
    state.add(guard.pause_left_.nanoseconds);
    state.add(guard.wished_);
    state.add(guard.last_step_);
    return state.text;
  }

  void add(std::int64_t number) { text.append(reinterpret_cast<const char*>(&number), sizeof number); }
  void add(int number) { text += static_cast<char>(number); }
  void add(double number) { add(static_cast<std::int64_t>(std::llround(number * 1e7))); }
  void add(const WheelSpeeds& wheels) {
    add(wheels.left);
    add(wheels.right);
  }
  void add(const std::optional<Time>& time) {
    constexpr std::int64_t kOld = 5'000'000'000;
    add(time ? std::clamp((now - *time).nanoseconds, -kOld, kOld) : 2 * kOld);
  }
  void add(const ContactReading& c) {
    add((c.any_bumper() ? 1 : 0) + (c.any_cliff() ? 2 : 0) + (c.any_drop() ? 4 : 0));
  }
  void add(const WheelWatchdog& watchdog) {
    add(watchdog.arrival_);
    add(watchdog.commanded_);
    add(watchdog.arrival_ ? watchdog.obeyed_ : WheelSpeeds{});
    add(watchdog.last_step_);
    add(watchdog.output_.wheels);
    add(static_cast<int>(watchdog.output_.state));
    add(watchdog.is_catching_up_ ? 1 : 0);
  }
  void add(const LinkGuard& link) {
    add((link.link_.is_open ? 1 : 0) + (link.link_.openings != link.openings_ ? 2 : 0));
    add(link.first_look_);
    add(link.heard_);
    add(link.refused_since_);
  }
  void add(const ContactReaction& reaction, double travelled) {
    add(reaction.since_);
    add(reaction.since_ ? reaction.from_ - travelled : 0.0);
  }
  void add(const WheelGuard& wheels) {
    for (const WheelGuard::Command& command : wheels.commands_) {
      add(std::optional(command.time));
      add(command.wheels[0]);
      add(command.wheels[1]);
    }
    for (const WheelGuard::Side& side : wheels.sides_) {
      add(side.is_known ? 1 : 0);
      for (const double number : {side.lo, side.hi, side.below, side.above, side.seconds, side.distance})
        add(number);
    }
  }
  void add(const BatteryGuard& battery) {
    add(static_cast<int>(battery.level_));
    add(battery.good_since_);
    add(battery.low_since_);
    add(battery.empty_since_);
  }

  Time now;
  std::string text;
};

}  // namespace bw
