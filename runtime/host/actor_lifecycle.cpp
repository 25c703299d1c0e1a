#include "runtime/host/actor_lifecycle.hpp"

#include <exception>
#include <stdexcept>
#include <utility>

#include "runtime/host/actor.hpp"
#include "runtime/host/runner.hpp"
#include "runtime/thrown.hpp"

namespace bw {

using lifecycle::Outcome;
using lifecycle::State;
namespace id = lifecycle::transition_id;

namespace {

/// What it means that the work of a transition was not done. Upwards nothing has changed; who cannot be
/// brought to rest is not to be trusted with a second try; what is shut down is shut down.
Outcome outcome_of_failure(std::uint8_t transition) {
  switch (transition) {
    case id::kConfigure:
    case id::kActivate:
      return Outcome::failure;
    case id::kDeactivate:
    case id::kCleanup:
      return Outcome::error;
    default:
      return Outcome::failure;
  }
}

}  // namespace

void ActorLifecycle::wait_for_configure() {
  instance_is_ready_ = true;
  actor_.state = State::unconfigured;
  actor_.live_parameters.set_configured(false);
}

void ActorLifecycle::enter(const lifecycle::Transition& transition, Time now) {
  actor_.state = transition.goal;
  if (is_running_ && means_.tell) means_.tell(transition, now);
}

std::string ActorLifecycle::change(const lifecycle::Transition& transition, Time now) {
  enter(transition, now);
  const std::string reason = work(transition, now);
  const Outcome outcome = reason.empty() ? Outcome::success : outcome_of_failure(transition.id);
  enter(finishing_transition(actor_.state, outcome), now);
  if (actor_.state == State::errorprocessing) {
    give_up();
    enter(finishing_transition(State::errorprocessing, Outcome::success), now);
  }
  if (!reason.empty() && means_.log_error) {
    means_.log_error(std::string(transition.label) + " failed, now " + std::string(label(actor_.state)) +
                     ": " + reason);
  }
  if (!actor_.is_active()) return reason;
  ++actor_.activations;
  try {
    begin_hearing(now);
  } catch (...) {
    const std::string what = thrown_text();
    static_cast<void>(change(*lifecycle::requested_transition(State::active, 0, "deactivate"), now));
    return "a latched message: " + what;
  }
  return reason;
}

std::string ActorLifecycle::work(const lifecycle::Transition& transition, Time now) {
  try {
    switch (transition.id) {
      case id::kConfigure:
        configure();
        actor_.live_parameters.set_configured(true);
        break;
      case id::kActivate:
        activate(now);
        break;
      case id::kDeactivate:
        deactivate(now);
        break;
      case id::kActiveShutdown:
        deactivate(now);
        cleanup();
        break;
      case id::kCleanup:
      case id::kInactiveShutdown:
        cleanup();
        break;
      case id::kUnconfiguredShutdown:
        destroy();
        break;
      default:
        return "no such transition";
    }
  } catch (...) {
    const std::string what = thrown_text();
    mute();
    if (transition.goal == State::shuttingdown) give_up();
    return what.empty() ? "it threw" : what;
  }
  return {};
}

void ActorLifecycle::configure() {
  if (std::exchange(instance_is_ready_, false) || !means_.make) return;
  {
    const std::lock_guard lock(actor_.mutex);
    actor_.diagnostic_level = DiagnosticReporter::Level::ok;
    actor_.diagnostic_message = "ok";
    actor_.diagnostic_values.clear();
  }
  std::unique_ptr<Component> instance = means_.make();
  means_.configure(*instance);
  actor_.component = std::move(instance);
  for (const auto& input : actor_.inputs) {
    input->calls = 0;
    for (Input::Kept& kept : input->kept) kept.is_given = false;
  }
  for (const auto& timer : actor_.timers) timer->calls = 0;
}

void ActorLifecycle::activate(Time now) {
  // What the host brings up at the start comes before anything of the others is known.
  if (is_running_ && means_.rivals) {
    if (const std::string rivals = means_.rivals(); !rivals.empty()) throw std::runtime_error(rivals);
  }
  for (const auto& output : actor_.outputs) output->sink = runner_;
  actor_.component->activate({.now = now});
}

void ActorLifecycle::deactivate(Time now) {
  actor_.component->deactivate({.now = now, .health = Health::stop});
  mute();
  forget_messages(now);
}

/// The world moves on meanwhile. A latched message holds until the next one.
void ActorLifecycle::forget_messages(Time now) {
  if (!is_running_) return;
  for (const auto& input : actor_.inputs) {
    const bool is_kept =
        input->kind == InputKind::keep_newest && input->qos.durability == Durability::volatile_;
    if (is_kept && !input->of_node) input->handler({}, {.now = now});
  }
}

void ActorLifecycle::cleanup() {
  actor_.component->cleanup();
  destroy();
}

/// Who has no lifecycle of its own speaks to the end.
void ActorLifecycle::mute() {
  for (const auto& action : actor_.actions) {
    if (action->runner != nullptr) action->abandon(actor_.not_active(), runner_->now());
  }
  if (!means_.make) return;
  for (const auto& output : actor_.outputs) {
    if (!output->of_node) output->sink = nullptr;
  }
  for (const auto& timer : actor_.timers) {
    if (!timer->of_node) runner_->schedule(*timer, Timer::kNever);
  }
  for (const auto& client : actor_.clients) {
    if (!client->of_node) client->forget_calls();
  }
}

/// Its own cleanup too, if it still can.
void ActorLifecycle::give_up() {
  try {
    if (actor_.component != nullptr) actor_.component->cleanup();
  } catch (...) {
    if (means_.log_error) means_.log_error("cleanup failed: " + thrown_text());
  }
  destroy();
}

/// Nothing that the instance gave away may be called again. An instance that is the only one stays.
void ActorLifecycle::destroy() {
  mute();
  instance_is_ready_ = false;
  if (!means_.make) return;
  actor_.live_parameters.set_configured(false);
  for (const auto& input : actor_.inputs) {
    if (!input->of_node) input->handler = nullptr;
  }
  for (const auto& timer : actor_.timers) {
    if (!timer->of_node) timer->handler = nullptr;
  }
  for (const auto& service : actor_.services) {
    if (!service->of_node) service->handler.handle = nullptr;
  }
  for (const auto& action : actor_.actions) {
    action->handler.on_goal = nullptr;
    action->handler.on_cancel = nullptr;
  }
  actor_.component.reset();
}

/// Ages and ticks count from now on. What a latched topic has said meanwhile, or before this instance was, it
/// hears now: the same reader would not get it again.
void ActorLifecycle::begin_hearing(Time now) {
  {
    const std::lock_guard lock(actor_.mutex);
    for (const auto& input : actor_.inputs) input->last_received = now;
  }
  for (const auto& timer : actor_.timers) {
    if (!timer->of_node && is_running_) runner_->schedule(*timer, now + timer->period);
  }
  for (const auto& input : actor_.inputs) {
    for (Input::Kept& kept : input->kept) {
      if (!std::exchange(kept.is_given, true)) actor_.give(*input, kept.writer, kept.cdr, now);
    }
  }
}

}  // namespace bw
