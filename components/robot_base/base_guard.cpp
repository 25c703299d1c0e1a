#include "components/robot_base/base_guard.hpp"

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
      watchdog_(options.watchdog, robot.limits.stop_deceleration, robot.limits.acc_max),
      link_(options.link),
      reaction_(options.contacts, robot.limits.stop_deceleration),
      wheels_(options.wheels, robot, response),
      battery_(options.battery),
      latch_(options.restart) {}

void BaseGuard::set_emergency_stop(Time now, bool is_on, const std::string& reason) {
  latch_.set(now, StopCause::emergency_stop, is_on, reason);
}

void BaseGuard::read(Time now, const Readings& readings) {
  link_.read(now, readings.link, !readings.counts.empty());
  if (readings.contacts) read_contacts(now, *readings.contacts);
  if (readings.currents) {
    const std::string which = sides(readings.currents->is_over_left, false, readings.currents->is_over_right);
    overcurrent_ = which.empty() ? "" : "overcurrent:" + which;
  }
  const std::string& fault = readings.fault.empty() ? overcurrent_ : readings.fault;
  latch_.set(now, StopCause::device, !fault.empty(), fault);
  if (!readings.battery) return;
  const BatteryReading& battery = *readings.battery;
  const bool is_empty = battery_.read(now, battery.voltage) == BatteryLevel::empty;
  latch_.set(now, StopCause::battery, is_empty, "the battery is empty");
  latch_.set(now, StopCause::charging, battery.is_charging || battery.is_plugged, "the charger is connected");
}

void BaseGuard::read_contacts(Time now, const ContactReading& contacts) {
  const bool was_touched = contacts_.any_bumper() || contacts_.any_cliff() || contacts_.any_drop();
  contacts_ = contacts;
  latch_.set(now, StopCause::bumper, contacts.any_bumper(),
             "bumper:" + sides(contacts.bumper_left, contacts.bumper_centre, contacts.bumper_right));
  latch_.set(now, StopCause::cliff, contacts.any_cliff(),
             "cliff:" + sides(contacts.cliff_left, contacts.cliff_centre, contacts.cliff_right));
  latch_.set(now, StopCause::wheel_drop, contacts.any_drop(),
             "wheel drop:" + sides(contacts.drop_left, false, contacts.drop_right));
  const bool is_touched = contacts.any_bumper() || contacts.any_cliff();
  if (is_touched && !was_touched) reaction_.touch(now, travelled_, contacts, output_.wheels != WheelSpeeds{});
}

void BaseGuard::moved(Time now, Time stamp, const WheelTravel& travel) {
  travelled_ += (travel.left + travel.right) / 2.0;
  const WheelVerdict verdict = wheels_.measured(stamp, travel);
  if (verdict == WheelVerdict::sound) return;
  const StopCause cause = verdict == WheelVerdict::stall ? StopCause::stall : StopCause::runaway;
  latch_.strike(now, cause, wheels_.reason());
}

BaseOutput BaseGuard::step(Time now) {
  const LinkHealth health = link_.look(now);
  const bool is_lost = health == LinkHealth::lost || health == LinkHealth::reopened;
  latch_.set(now, StopCause::link, is_lost, link_.reason());
  if (health != LinkHealth::heard) wheels_.reset();
  latch_.step(now);
  output_ = decide(now, health);
  last_step_ = now;
  return output_;
}

BaseOutput BaseGuard::decide(Time now, LinkHealth health) {
  if (!may_back_off()) reaction_.end();
  if (const auto back = reaction_.step(now, travelled_, contacts_)) {
    watchdog_.overrule(now, *back);
    const StopCause cause = *latch_.holds();
    return {*back, BaseCondition::backing_off, latch_.is_latched(cause), latch_.reason(cause)};
  }
  if (const auto cause = latch_.holds()) {
    const bool is_at_once = health == LinkHealth::reopened || latch_.holds(StopCause::wheel_drop) ||
                            latch_.holds(StopCause::cliff) || latch_.holds(StopCause::bumper);
    const double dt = last_step_ && now > *last_step_ ? (now - *last_step_).to_seconds() : 0.0;
    const WheelSpeeds wheels = is_at_once ? WheelSpeeds{} : brake(output_.wheels, stop_deceleration_, dt);
    watchdog_.overrule(now, wheels);
    return {wheels, condition_of(*cause), latch_.is_latched(*cause), latch_.reason(*cause)};
  }
  if (health == LinkHealth::unheard) {
    watchdog_.overrule(now, {});
    const bool is_told = !link_.reason().empty();
    return {{}, is_told ? BaseCondition::link : BaseCondition::waiting, false, link_.reason()};
  }
  const WatchdogOutput output = watchdog_.step(now);
  const bool drives = output.state == WatchdogState::obeying;
  return {.wheels = output.wheels,
          .condition = drives ? BaseCondition::driving : BaseCondition::waiting,
          .commands = output.state};
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
  const std::optional<std::string> refusal = latch_.release();
  if (refusal) return refusal;
  wheels_.reset();
  watchdog_.revoke();
  return std::nullopt;
}

}  // namespace bw
