#include "runtime/lifecycle/state_machine.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <string>

namespace bw::lifecycle {
namespace {

constexpr std::array kStates = {
    State::unknown,    State::unconfigured, State::inactive,        State::active,
    State::finalized,  State::configuring,  State::cleaningup,      State::shuttingdown,
    State::activating, State::deactivating, State::errorprocessing,
};

constexpr std::string_view kSuccess = "transition_success";
constexpr std::string_view kFailure = "transition_failure";
constexpr std::string_view kError = "transition_error";

constexpr std::array<Transition, 25> kTransitions = {{
    {transition_id::kConfigure, "configure", State::unconfigured, State::configuring},
    {10, kSuccess, State::configuring, State::inactive},
    {11, kFailure, State::configuring, State::unconfigured},
    {12, kError, State::configuring, State::errorprocessing},
    {transition_id::kCleanup, "cleanup", State::inactive, State::cleaningup},
    {20, kSuccess, State::cleaningup, State::unconfigured},
    {21, kFailure, State::cleaningup, State::inactive},
    {22, kError, State::cleaningup, State::errorprocessing},
    {transition_id::kActivate, "activate", State::inactive, State::activating},
    {30, kSuccess, State::activating, State::active},
    {31, kFailure, State::activating, State::inactive},
    {32, kError, State::activating, State::errorprocessing},
    {transition_id::kDeactivate, "deactivate", State::active, State::deactivating},
    {40, kSuccess, State::deactivating, State::inactive},
    {41, kFailure, State::deactivating, State::active},
    {42, kError, State::deactivating, State::errorprocessing},
    {transition_id::kUnconfiguredShutdown, "shutdown", State::unconfigured, State::shuttingdown},
    {transition_id::kInactiveShutdown, "shutdown", State::inactive, State::shuttingdown},
    {transition_id::kActiveShutdown, "shutdown", State::active, State::shuttingdown},
    {50, kSuccess, State::shuttingdown, State::finalized},
    {51, kFailure, State::shuttingdown, State::finalized},
    {52, kError, State::shuttingdown, State::errorprocessing},
    {60, kSuccess, State::errorprocessing, State::unconfigured},
    {61, kFailure, State::errorprocessing, State::finalized},
    {62, kError, State::errorprocessing, State::finalized},
}};

bool is_transitional(State state) { return state >= State::configuring; }

}  // namespace

std::span<const State> states() { return kStates; }

std::string_view label(State state) {
  switch (state) {
    case State::unknown:
      return "unknown";
    case State::unconfigured:
      return "unconfigured";
    case State::inactive:
      return "inactive";
    case State::active:
      return "active";
    case State::finalized:
      return "finalized";
    case State::configuring:
      return "configuring";
    case State::cleaningup:
      return "cleaningup";
    case State::shuttingdown:
      return "shuttingdown";
    case State::activating:
      return "activating";
    case State::deactivating:
      return "deactivating";
    case State::errorprocessing:
      return "errorprocessing";
  }
  return "unknown";
}

std::span<const Transition> transitions() { return kTransitions; }

std::vector<Transition> transitions_from(State state) {
  std::vector<Transition> found;
  std::ranges::copy_if(kTransitions, std::back_inserter(found),
                       [&](const Transition& t) { return t.start == state; });
  return found;
}

const Transition* requested_transition(State from, std::uint8_t id, std::string_view label) {
  if (is_transitional(from)) return nullptr;
  const auto found = std::ranges::find_if(kTransitions, [&](const Transition& t) {
    return t.start == from && (label.empty() ? t.id == id : t.label == label);
  });
  return found == kTransitions.end() ? nullptr : &*found;
}

const Transition& finishing_transition(State state, Outcome outcome) {
  const std::string_view wanted = outcome == Outcome::success   ? kSuccess
                                  : outcome == Outcome::failure ? kFailure
                                                                : kError;
  const auto found = std::ranges::find_if(kTransitions, [&](const Transition& t) {
    return is_transitional(state) && t.start == state && t.label == wanted;
  });
  if (found == kTransitions.end())
    throw std::logic_error(std::string(label(state)) + " is no state on the way");
  return *found;
}

}  // namespace bw::lifecycle
