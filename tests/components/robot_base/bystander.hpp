// Somebody who stands beside a base, sees what happens to it and what it is told to do, and knows nothing of
// its guard: what they would not forgive. Wheels of one speed, forward commands of one speed.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "components/robot_base/base_guard.hpp"

namespace bw {

class Bystander {
 public:
  static constexpr double kSpeed = 0.4;         ///< that is commanded [m/s]
  static constexpr double kDeceleration = 2.0;  ///< of the default robot [m/s^2]
  static constexpr double kAcceleration = 1.0;
  static constexpr double kTimeout = 0.2;  ///< of commands [s]

  /// What is known when the guard answers.
  struct Scene {
    double seconds = 0.0;                        ///< since the answer before
    double moved = 0.0;                          ///< of the base since then, forward [m]
    std::array<bool, kStopCauses> is_present{};  ///< what it can know of
    bool is_reopened = false, is_clock_stepped = false;
    bool is_blocked = false;       ///< the wheels
    bool is_told_forward = false;  ///< the newest command, and not older than the time-out
    bool is_told_to_stand = false;
    bool has(StopCause cause) const { return is_present[static_cast<std::size_t>(cause)]; }
  };

  explicit Bystander(const BaseGuardOptions& options) : options_(options) {}

  const std::string& objection() const { return objection_; }

  void released() {
    if (needs_release_) freed_ = 0.0;
    needs_release_ = false;
  }

  void look(const Scene& scene, const BaseOutput& output) {
    remember(scene, output);
    const double v = output.wheels.left;
    object(!(std::isfinite(v) && v == output.wheels.right), "not one finite speed");
    object(v > kSpeed + kHair || v < -options_.contacts.kSpeed - kHair, "faster than anybody asked for");
    if (v < 0.0) look_back(scene, output);
    look_at_rest(scene, output);
    look_at_changes(scene, v);
    const bool is_wheel_alarm =
        output.condition == BaseCondition::stall || output.condition == BaseCondition::runaway;
    object(is_wheel_alarm && !was_blocked_, "a fault of wheels that do as they are told");
    speed_ = v;
  }

  /// For GuardState: all that decides what it objects to.
  template <class State>
  void add_to(State& state) const {
    for (const double value : {std::min(freed_, kLong), std::min(held_, kLong), std::min(stepped_, 0.2),
                               back_seconds_, back_metres_, speed_})
      state.add(value);
    state.add((needs_release_ ? 1 : 0) + (must_rise_slowly_ ? 2 : 0) + (was_blocked_ ? 4 : 0));
  }

 private:
  static constexpr double kHair = 1e-9, kLong = 10.0;
  static constexpr double kRamp = kSpeed / kDeceleration + 0.1;  ///< and what steps of the clock cost

  void object(bool is_wrong, const char* text) {
    if (is_wrong && objection_.empty()) objection_ = text;
  }

  void remember(const Scene& scene, const BaseOutput& output) {
    stepped_ = scene.is_clock_stepped ? 0.0 : stepped_ + scene.seconds;
    freed_ += scene.is_clock_stepped ? std::max(scene.seconds, 0.1) : scene.seconds;
    const bool wants = scene.is_told_forward || speed_ != 0.0;
    bool is_any = scene.is_reopened;
    for (std::size_t i = 0; i < kStopCauses; ++i) {
      if (!scene.is_present[i]) continue;
      const Restart restart = options_.restart.of(static_cast<StopCause>(i));
      needs_release_ |= restart == Restart::released || (restart == Restart::if_idle && wants);
      is_any = true;
    }
    needs_release_ |= output.is_latched;
    if (is_any || output.condition > BaseCondition::waiting) freed_ = 0.0;
    is_held_ = is_any || needs_release_ || freed_ < options_.restart.pause - kHair;
    held_ = is_held_ ? held_ + scene.seconds : 0.0;
    must_rise_slowly_ |= is_held_;
    is_stopped_ = is_any || needs_release_;
    was_blocked_ |= scene.is_blocked;
    const bool is_sound = output.condition == BaseCondition::driving && speed_ == kSpeed && !scene.is_blocked;
    was_blocked_ &= !is_sound;
  }

  void look_back(const Scene& scene, const BaseOutput& output) {
    // A step of the clock costs a tenth of a second of odometry.
    const double not_measured = 0.1 * options_.contacts.kSpeed;
    if (speed_ >= 0.0) {
      back_seconds_ = 0.0;
      back_metres_ = stepped_ < 0.15 ? -not_measured : 0.0;
      object(speed_ == 0.0, "it stood and backs off");
      object(!scene.has(StopCause::bumper) && !scene.has(StopCause::cliff), "backs off from nothing");
    }
    back_seconds_ = scene.is_clock_stepped ? 0.0 : back_seconds_ + scene.seconds;
    back_metres_ -= std::min(scene.moved, 0.0) + (scene.is_clock_stepped ? not_measured : 0.0);
    object(output.condition != BaseCondition::backing_off, "goes back and does not say so");
    object(back_seconds_ > options_.contacts.time_limit + 0.05, "backs off for too long");
    object(back_metres_ > options_.contacts.distance, "backs off too far");
    for (const StopCause cause : {StopCause::emergency_stop, StopCause::wheel_drop, StopCause::link,
                                  StopCause::device, StopCause::charging})
      object(scene.has(cause), "backs off though something else forbids it");
  }

  void look_at_rest(const Scene& scene, const BaseOutput& output) {
    const double v = output.wheels.left;
    if (is_held_) {
      object(v > std::max(speed_, 0.0) + kHair, "sets off though nobody released it, or at once");
      object(v > 0.0 && held_ > kRamp, "does not come to rest");
    }
    if (is_stopped_) {
      object(output.condition <= BaseCondition::waiting, "does not say that it is stopped");
      object(output.reason.empty(), "does not say why it stands");
      object(needs_release_ != output.is_latched, "does not say whether it takes a release");
    }
    object(is_held_ && !is_stopped_ && scene.is_told_forward && output.reason.empty(),
           "is about to drive on and does not say so");
    object(v > 0.0 && !scene.is_told_forward && v > speed_ + kHair, "drives without a command");
  }

  void look_at_changes(const Scene& scene, double v) {
    const bool is_at_once = scene.is_reopened || scene.has(StopCause::wheel_drop) ||
                            scene.has(StopCause::cliff) || scene.has(StopCause::bumper) ||
                            scene.is_told_to_stand || scene.is_clock_stepped;
    object(speed_ > 0.0 && !is_at_once && speed_ - v > kDeceleration * scene.seconds + kHair,
           "brakes too hard");
    object(must_rise_slowly_ && v > 0.0 && !scene.is_clock_stepped &&
               v - std::max(speed_, 0.0) > kAcceleration * scene.seconds + kHair,
           "sets off with a jerk");
    const bool is_obeyed = !is_held_ && v == (scene.is_told_forward ? kSpeed : 0.0) && v != speed_;
    if (is_obeyed || (!is_held_ && scene.is_told_to_stand)) must_rise_slowly_ = false;
  }

  BaseGuardOptions options_;
  std::string objection_;
  double speed_ = 0.0;      ///< that it was told before
  double freed_ = kLong;    ///< since something held it last, or its release [s]
  double held_ = 0.0;       ///< since something or its pause holds it
  double stepped_ = kLong;  ///< since the clock did
  double back_seconds_ = 0.0, back_metres_ = 0.0;
  bool needs_release_ = false, is_held_ = false, is_stopped_ = false, must_rise_slowly_ = false;
  bool was_blocked_ = false;  ///< since it drove as told last
};

}  // namespace bw
