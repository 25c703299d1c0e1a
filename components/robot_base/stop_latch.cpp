#include "components/robot_base/stop_latch.hpp"

#include <algorithm>

namespace bw {

Restart StopOptions::of(StopCause cause) const {
  switch (cause) {
    case StopCause::emergency_stop:
      return Restart::released;
    case StopCause::wheel_drop:
      return wheel_drop;
    case StopCause::cliff:
      return cliff;
    case StopCause::bumper:
      return bumper;
    case StopCause::runaway:
      return runaway;
    case StopCause::stall:
      return stall;
    case StopCause::link:
      return link;
    case StopCause::device:
      return device;
    case StopCause::battery:
      return battery;
    case StopCause::charging:
      return charging;
  }
  return Restart::released;
}

void StopLatch::set(StopCause cause, bool is_present, const std::string& reason) {
  Held& held = held_[static_cast<std::size_t>(cause)];
  held.is_present = is_present;
  if (!is_present) return;
  held.holds = true;
  held.reason = reason;
}

void StopLatch::interrupt() {
  for (Held& held : held_) held.has_interrupted = held.holds;
}

void StopLatch::let_go() {
  for (std::size_t i = 0; i < kStopCauses; ++i) {
    const Held& held = held_[i];
    if (held.holds && !held.is_present && !is_latched(static_cast<StopCause>(i))) held_[i] = {};
  }
}

std::optional<StopCause> StopLatch::holds() const {
  const auto held = std::ranges::find_if(held_, &Held::holds);
  if (held == held_.end()) return std::nullopt;
  return static_cast<StopCause>(held - held_.begin());
}

bool StopLatch::is_latched() const {
  for (std::size_t i = 0; i < kStopCauses; ++i) {
    if (is_latched(static_cast<StopCause>(i))) return true;
  }
  return false;
}

bool StopLatch::is_latched(StopCause cause) const {
  const Restart restart = options_.of(cause);
  return at(cause).holds &&
         (restart == Restart::released || (restart == Restart::if_idle && at(cause).has_interrupted));
}

std::optional<std::string> StopLatch::release() {
  for (std::size_t i = 0; i < kStopCauses; ++i) {
    const auto cause = static_cast<StopCause>(i);
    if (is_latched(cause) && held_[i].is_present) return held_[i].reason;
  }
  for (std::size_t i = 0; i < kStopCauses; ++i) {
    if (is_latched(static_cast<StopCause>(i))) held_[i] = {};
  }
  return std::nullopt;
}

}  // namespace bw
