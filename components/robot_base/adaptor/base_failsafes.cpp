#include "components/robot_base/adaptor/base_failsafes.hpp"

#include <string>

namespace bw {
namespace {

struct Words {
  StopCause cause;
  const char* name;
  const char* condition;
};

constexpr std::array<Words, kStopCauses> kWords = {{
    {StopCause::emergency_stop, "emergency_stop", "somebody pressed it, or a listed button is silent"},
    {StopCause::wheel_drop, "wheel_drop", "a wheel hangs"},
    {StopCause::cliff, "cliff", "no floor ahead"},
    {StopCause::bumper, "bumper", "a bumper touches something"},
    {StopCause::runaway, "runaway", "wheels turn otherwise than told"},
    {StopCause::stall, "stall", "wheels lag behind what they are told"},
    {StopCause::link, "link", "the base is not heard, or its port was opened anew"},
    {StopCause::device, "device", "the base tells of a fault"},
    {StopCause::battery, "battery", "the battery is empty"},
    {StopCause::charging, "charging", "the charger is connected"},
}};

std::string recovery_of(Restart restart) {
  switch (restart) {
    case Restart::released:
      return "by release_stop";
    case Restart::if_idle:
      return "by release_stop; by itself where nobody wanted motion meanwhile";
    case Restart::by_itself:
      return "by itself, once the cause is over";
  }
  return {};
}

}  // namespace

BaseFailsafes::BaseFailsafes(Setup& setup, const BaseGuardOptions& options) {
  for (std::size_t i = 0; i < kStopCauses; ++i) {
    const Words& words = kWords[i];
    const Restart restart = options.restart.of(words.cause);
    const bool is_latched = restart != Restart::by_itself;
    const Duration debounce = words.cause == StopCause::link      ? Duration::seconds(options.link.silence)
                              : words.cause == StopCause::battery ? Duration::seconds(options.battery.lasting)
                                                                  : Duration{};
    causes_[static_cast<std::size_t>(words.cause)] =
        setup.failsafe({.name = words.name,
                        .condition = words.condition,
                        .debounce = debounce,
                        .action = is_latched ? FailsafeAction::stop_latched : FailsafeAction::stop,
                        .recovery = recovery_of(restart)});
  }
  silent_ = setup.failsafe({.name = "command_silent",
                            .condition = "wheel commands are silent while it moves",
                            .debounce = Duration::seconds(options.watchdog.timeout),
                            .recovery = "by itself, with the next command"});
}

void BaseFailsafes::show(const BaseOutput& output) const {
  for (std::size_t i = 0; i < kStopCauses; ++i)
    causes_[i].set(output.condition == condition_of(static_cast<StopCause>(i)));
  silent_.set(output.commands == WatchdogState::stopping);
}

}  // namespace bw
