// A base behind its guard to which anything happens, asked as robot_base asks it: at once at commands, the
// emergency stop and a release, else at the poll every 10 ms. Wheels do what they are told, or are blocked;
// those of a base that is not heard stand. After every answer it is judged by a bystander.
#pragma once

#include <cmath>
#include <string>

#include "tests/components/robot_base/bystander.hpp"
#include "tests/components/robot_base/guard_state.hpp"

namespace bw {

class BaseAmongEvents {
 public:
  enum class Commands { none, zero, forward };

  explicit BaseAmongEvents(const BaseGuardOptions& options)
      : guard_(options, Robot{}, 0.1), bystander_(options) {
    poll_.link = {.is_open = true, .device = "base", .openings = 1};
    poll_.contacts = ContactReading{};
    poll_.battery = BatteryReading{.voltage = 15.0};
    pass(0.05);
  }

  const std::string& broken() const { return bystander_.objection(); }
  std::string state() const {
    GuardState all{now_, GuardState::of(guard_, now_)};
    all.add(*poll_.contacts);
    all.add((is_pressed_ ? 1 : 0) + (poll_.fault.empty() ? 0 : 2) + (poll_.battery->is_plugged ? 4 : 0) +
            (poll_.battery->voltage < kEmpty ? 8 : 0) + (poll_.link.is_open ? 16 : 0) +
            (is_blocked_ ? 32 : 0));
    all.add((is_even_ ? 1 : 0) + (is_clock_stepped_ ? 2 : 0) + 4 * static_cast<int>(commands_) +
            16 * static_cast<int>(said_));
    all.add(std::min(silent_, 1.0));
    all.add(distance_);
    all.add(unread_);
    all.add(stale_);
    all.add(polled_.contacts.value_or(ContactReading{}));
    all.add((polled_.fault.empty() ? 0 : 2) + (polled_.battery && polled_.battery->is_plugged ? 4 : 0) +
            (polled_.link.is_open ? 16 : 0) + (polled_.link.openings != poll_.link.openings ? 32 : 0));
    bystander_.add_to(all);
    return all.text;
  }

  // What happens.
  void bumper() { poll_.contacts->bumper_centre = !poll_.contacts->bumper_centre; }
  void cliff() { poll_.contacts->cliff_left = !poll_.contacts->cliff_left; }
  void wheel_drop() { poll_.contacts->drop_left = !poll_.contacts->drop_left; }
  void fault() { poll_.fault = poll_.fault.empty() ? "a fault" : ""; }
  void charger() { poll_.battery->is_plugged = !poll_.battery->is_plugged; }
  void battery() { poll_.battery->voltage = poll_.battery->voltage < kEmpty ? 15.0 : 12.0; }
  void block() { is_blocked_ = !is_blocked_; }
  void cable() {
    poll_.link.is_open = !poll_.link.is_open;
    if (poll_.link.is_open) ++poll_.link.openings;
  }
  void reopen() {
    if (poll_.link.is_open) ++poll_.link.openings;
  }
  void emergency_stop() {
    is_pressed_ = !is_pressed_;
    guard_.set_emergency_stop(is_pressed_);
    ask(0.0);
  }
  void release() {
    if (guard_.release()) return;
    bystander_.released();
    ask(0.0);
  }
  void command(Commands commands) {
    commands_ = commands;
    say();
  }
  void step_clock(double seconds) {
    now_ = now_ + Duration::seconds(seconds);
    silent_ = 10.0;  // nobody knows how old the newest command is
    is_clock_stepped_ = true;
    // Odometry takes five readings to believe a clock that went back, and a step on for a long time between
    // two.
    stale_ = seconds < 0.0 ? 5 : stale_;
    unread_ += std::max(0.0, seconds);
  }
  void pass(double seconds) {
    for (long i = std::lround(seconds * 100.0); i > 0 && broken().empty(); --i) tick();
  }

 private:
  static constexpr double kEmpty = 13.0;

  void say() {
    if (commands_ == Commands::none) return;
    said_ = commands_;
    silent_ = 0.0;
    guard_.command(now_, commands_ == Commands::forward ? WheelSpeeds{Bystander::kSpeed, Bystander::kSpeed}
                                                        : WheelSpeeds{});
    ask(0.0);
  }

  void tick() {
    now_ = now_ + Duration::milliseconds(10);
    is_even_ = !is_even_;
    silent_ += 0.01;
    unread_ += 0.01;
    const double moved = is_blocked_ || !poll_.link.is_open ? 0.0 : speed_ * 0.01;
    distance_ += moved;
    Readings readings = poll_;
    if (is_even_ && poll_.link.is_open) readings.counts = {{now_, 0, 0}};
    guard_.read(now_, readings);
    if (!readings.counts.empty()) {
      if (stale_ == 0) guard_.moved(now_, {unread_, distance_, distance_});
      stale_ = std::max(stale_ - 1, 0);
      distance_ = unread_ = 0.0;
    }
    const bool is_reopened = polled_.link.openings != 0 && polled_.link.openings != poll_.link.openings;
    polled_ = poll_;
    ask(0.01, moved, is_reopened);
    if (is_even_) say();
  }

  void ask(double seconds, double moved = 0.0, bool is_reopened = false) {
    const bool is_fresh = silent_ < Bystander::kTimeout - 1e-9;
    Bystander::Scene scene{.seconds = seconds,
                           .moved = moved,
                           .is_reopened = is_reopened,
                           .is_clock_stepped = is_clock_stepped_,
                           .is_blocked = is_blocked_,
                           .is_told_forward = is_fresh && said_ == Commands::forward,
                           .is_told_to_stand = is_fresh && said_ == Commands::zero};
    const auto present = [&](StopCause cause, bool is_present) {
      scene.is_present[static_cast<std::size_t>(cause)] = is_present;
    };
    const ContactReading contacts = polled_.contacts.value_or(ContactReading{});
    present(StopCause::emergency_stop, is_pressed_);
    present(StopCause::wheel_drop, contacts.any_drop());
    present(StopCause::cliff, contacts.any_cliff());
    present(StopCause::bumper, contacts.any_bumper());
    present(StopCause::link, !polled_.link.is_open && polled_.link.openings != 0);
    present(StopCause::device, !polled_.fault.empty());
    present(StopCause::charging, polled_.battery && polled_.battery->is_plugged);
    const BaseOutput output = guard_.step(now_);
    guard_.told(now_, output.wheels, polled_.link.is_open);
    bystander_.look(scene, output);
    speed_ = output.wheels.left;
    is_clock_stepped_ = false;
  }

  BaseGuard guard_;
  Bystander bystander_;
  Time now_ = Time::seconds(1000.0);
  Readings poll_, polled_;  ///< what the driver tells, and told last
  bool is_pressed_ = false, is_blocked_ = false, is_even_ = false, is_clock_stepped_ = false;
  Commands commands_ = Commands::none, said_ = Commands::none;
  double silent_ = 10.0;  ///< since the newest command, by the clock [s]
  double speed_ = 0.0;
  double distance_ = 0.0, unread_ = 0.0;  ///< since the reading before [m], [s]
  int stale_ = 0;
};

}  // namespace bw
