#include "components/robot_base/base_guard.hpp"

#include <algorithm>
#include <cmath>

#include "components/model/stopping.hpp"

namespace bw {
namespace {

std::string sides(bool left, bool centre, bool right) {
  std::string text;
  if (left) text += " left";
  if (centre) text += " centre";
  if (right) text += " right";
  return text;
}

}  // namespace

BaseGuard::BaseGuard(const BaseGuardOptions& options, const Robot& robot, double response)
    : stop_deceleration_(robot.limits.stop_deceleration),
      pause_(Duration::seconds(options.restart.pause)),
      timeout_(Duration::seconds(options.watchdog.timeout)),
      silence_(Duration::seconds(options.link.silence)),
      watchdog_(options.watchdog, robot.limits.stop_deceleration, robot.limits.acc_max),
      link_(options.link),
      reaction_(options.contacts, robot.limits.stop_deceleration),
      wheels_(options.wheels, robot, response),
      battery_(options.battery),
      latch_(options.restart) {}

bool BaseGuard::command(Time now, const WheelSpeeds& wheels) {
  if (!watchdog_.command(now, wheels)) return false;
  wished_ = wheels == WheelSpeeds{} ? std::nullopt : std::optional(now);
  return true;
}

void BaseGuard::set_emergency_stop(bool is_on, const std::string& reason) {
  latch_.set(StopCause::emergency_stop, is_on, reason);
}

void BaseGuard::read(Time now, const Readings& readings) {
  link_.read(now, readings.link, !readings.counts.empty());
  if (readings.contacts) read_contacts(now, *readings.contacts);
  if (readings.currents) {
    const std::string which = sides(readings.currents->is_over_left, false, readings.currents->is_over_right);
    overcurrent_ = which.empty() ? "" : "overcurrent:" + which;
  }
  const std::string& fault = readings.fault.empty() ? overcurrent_ : readings.fault;
  latch_.set(StopCause::device, !fault.empty(), fault);
  if (!readings.battery) return;
  const BatteryReading& battery = *readings.battery;
  const bool is_empty = battery_.read(now, battery.voltage) == BatteryLevel::empty;
  latch_.set(StopCause::battery, is_empty, "the battery is empty");
  latch_.set(StopCause::charging, battery.is_charging || battery.is_plugged, "the charger is connected");
}

void BaseGuard::read_contacts(Time now, const ContactReading& contacts) {
  const bool was_touched = contacts_.any_bumper() || contacts_.any_cliff() || contacts_.any_drop();
  contacts_ = contacts;
  latch_.set(StopCause::bumper, contacts.any_bumper(),
             "bumper:" + sides(contacts.bumper_left, contacts.bumper_centre, contacts.bumper_right));
  latch_.set(StopCause::cliff, contacts.any_cliff(),
             "cliff:" + sides(contacts.cliff_left, contacts.cliff_centre, contacts.cliff_right));
  latch_.set(StopCause::wheel_drop, contacts.any_drop(),
             "wheel drop:" + sides(contacts.drop_left, false, contacts.drop_right));
  const bool is_touched = contacts.any_bumper() || contacts.any_cliff();
  if (is_touched && !was_touched) reaction_.touch(now, travelled_, contacts, output_.wheels != WheelSpeeds{});
}

void BaseGuard::moved(Time stamp, const WheelTravel& travel) {
  travelled_ += (travel.left + travel.right) / 2.0;
  // Unheard meanwhile, or the clock stepped: how fast it went is not known.
  if (Duration::seconds(travel.seconds) >= silence_) return wheels_.reset();
  const WheelVerdict verdict = wheels_.measured(stamp, travel);
  if (verdict == WheelVerdict::sound) return;
  const StopCause cause = verdict == WheelVerdict::stall ? StopCause::stall : StopCause::runaway;
  latch_.strike(cause, wheels_.reason());
}

BaseOutput BaseGuard::step(Time now) {
  const LinkHealth health = link_.look(now);
  const bool is_lost = health == LinkHealth::lost || health == LinkHealth::reopened;
  first_step_ = std::min(first_step_.value_or(now), now);
  takes_over_ = takes_over_ && now - *first_step_ < pause_;
  latch_.set(StopCause::link, is_lost || takes_over_,
             takes_over_ ? "the process of the base ended and was started again" : link_.reason());
  if (health != LinkHealth::heard) wheels_.reset();
  if (output_.wheels != WheelSpeeds{} || wants_motion(now)) latch_.interrupt();
  output_ = decide(now, health);
  // What it backs off from is not over before it stands again.
  if (!reaction_.is_backing_off()) latch_.let_go();
  last_step_ = now;
  return output_;
}

bool BaseGuard::wants_motion(Time now) const {
  return wished_ && *wished_ <= now && now - *wished_ < timeout_;
}

BaseOutput BaseGuard::decide(Time now, LinkHealth health) {
  const std::optional<StopCause> cause = latch_.holds();
  if (!cause || !may_back_off()) reaction_.end();
  if (cause) return stand(now, *cause, health == LinkHealth::reopened);
  if (health == LinkHealth::unheard) {
    watchdog_.overrule(now, {});
    const bool is_told = !link_.reason().empty();
    return {{}, is_told ? BaseCondition::link : BaseCondition::waiting, false, link_.reason()};
  }
  if (pause_left_ > Duration{}) return pause(now);
  const WatchdogOutput output = watchdog_.step(now);
  const bool drives = output.state == WatchdogState::obeying;
  return {.wheels = output.wheels,
          .condition = drives ? BaseCondition::driving : BaseCondition::waiting,
          .commands = output.state};
}

BaseOutput BaseGuard::stand(Time now, StopCause cause, bool is_reopened) {
  pause_left_ = pause_;
  const auto back = reaction_.step(now, travelled_, contacts_);
  const bool is_at_once = is_reopened || latch_.holds(StopCause::wheel_drop) ||
                          latch_.holds(StopCause::cliff) || latch_.holds(StopCause::bumper);
  const WheelSpeeds wheels = back ? *back : is_at_once ? WheelSpeeds{} : braked(now);
  watchdog_.overrule(now, wheels);
  return {wheels, back ? BaseCondition::backing_off : condition_of(cause), latch_.is_latched(),
          latch_.reason(cause)};
}

/// After all that held it: nobody is near who does not know that it drives on. A clock that jumps makes it no
/// shorter.
BaseOutput BaseGuard::pause(Time now) {
  constexpr Duration kLongestStep = Duration::milliseconds(100);
  BaseOutput output{.wheels = braked(now)};
  watchdog_.overrule(now, output.wheels);
  if (wants_motion(now)) {
    const auto seconds = static_cast<int>(std::ceil(pause_left_.to_seconds()));
    output.reason = "drives on in " + std::to_string(seconds) + " s";
  }
  const Duration elapsed = last_step_ ? now - *last_step_ : Duration{};
  pause_left_ = pause_left_ - std::clamp(elapsed, Duration{}, kLongestStep);
  return output;
}

WheelSpeeds BaseGuard::braked(Time now) const {
  const double dt = last_step_ && now > *last_step_ ? (now - *last_step_).to_seconds() : 0.0;
  return brake(output_.wheels, stop_deceleration_, dt);
}

bool BaseGuard::may_back_off() const {
  for (std::size_t i = 0; i < kStopCauses; ++i) {
    const auto cause = static_cast<StopCause>(i);
    if (cause != StopCause::bumper && cause != StopCause::cliff && latch_.holds(cause)) return false;
  }
  return true;
}

void BaseGuard::told(Time now, const WheelSpeeds& wheels, bool is_through) {
  link_.told(now, is_through);
  wheels_.commanded(now, wheels);
}

std::optional<std::string> BaseGuard::release() {
  if (reaction_.is_backing_off()) return "it is backing off";
  const bool is_held = latch_.holds().has_value();
  const std::optional<std::string> refusal = latch_.release();
  if (is_held && !refusal) wheels_.reset();
  return refusal;
}

}  // namespace bw
