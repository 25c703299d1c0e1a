#include "runtime/lifecycle/bring_up.hpp"

#include <utility>

namespace bw::lifecycle {
namespace {

constexpr std::string_view kConfigure = "configure";
constexpr std::string_view kCleanup = "cleanup";
constexpr std::string_view kActivate = "activate";
constexpr std::string_view kDeactivate = "deactivate";
constexpr std::string_view kShutdown = "shutdown";

/// A node in `state`, which has no such transition, is nevertheless where the transition leads, or further on
/// the way.
bool is_past(std::string_view transition, State state) {
  if (transition == kConfigure) return state == State::inactive || state == State::active;
  if (transition == kActivate) return state == State::active;
  if (transition == kDeactivate) return true;
  if (transition == kCleanup) return state == State::unconfigured || state == State::finalized;
  return state == State::finalized;
}

}  // namespace

std::optional<Command> command_of(std::uint8_t number) {
  if (number > static_cast<std::uint8_t>(Command::cleanup)) return std::nullopt;
  return static_cast<Command>(number);
}

std::vector<BringUp::Phase> BringUp::phases_of(Command command) {
  switch (command) {
    case Command::startup:
      return {{kConfigure}, {kActivate}};
    case Command::pause:
      return {{kDeactivate, true}};
    case Command::resume:
      return {{kActivate}};
    case Command::reset:
      return {{kDeactivate, true}, {kCleanup, true}};
    case Command::shutdown:
      return {{kDeactivate, true}, {kCleanup, true}, {kShutdown, true}};
    case Command::configure:
      return {{kConfigure}};
    case Command::cleanup:
      return {{kCleanup, true}};
  }
  return {};
}

BringUp::BringUp(Command command, std::vector<State> nodes)
    : nodes_(std::move(nodes)), phases_(phases_of(command)) {
  if (command == Command::startup || command == Command::resume) when_it_fails_ = phases_of(Command::pause);
}

std::optional<BringUp::Step> BringUp::next() {
  while (phase_ < phases_.size()) {
    if (position_ == nodes_.size()) {
      ++phase_;
      position_ = 0;
      continue;
    }
    const auto [name, backwards] = phases_[phase_];
    Step step{.node = backwards ? nodes_.size() - 1 - position_ : position_, .transition = name};
    step.from = nodes_[step.node];
    if (const Transition* transition = requested_transition(step.from, 0, name)) {
      step.id = transition->id;
      step.goal = finishing_transition(transition->goal, Outcome::success).goal;
      return step;
    }
    ++position_;
    if (!is_past(name, step.from)) fail(step);
  }
  return std::nullopt;
}

void BringUp::finished(State now) {
  const std::optional<Step> step = next();
  if (!step) return;
  nodes_[step->node] = now;
  ++position_;
  if (now != step->goal) fail(*step);
}

void BringUp::fail(const Step& step) {
  if (!failure_) failure_ = step;
  if (phases_[phase_].backwards) return;
  phases_ = std::exchange(when_it_fails_, {});
  phase_ = 0;
  position_ = 0;
}

}  // namespace bw::lifecycle
