// The states of a node and the ways between them, with the ids and labels of lifecycle_msgs and in the order
// in which ROS 2's own nodes list them (rcl_lifecycle, default state machine).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace bw::lifecycle {

enum class State : std::uint8_t {
  unknown = 0,
  unconfigured = 1,
  inactive = 2,
  active = 3,
  finalized = 4,
  configuring = 10,
  cleaningup = 11,
  shuttingdown = 12,
  activating = 13,
  deactivating = 14,
  errorprocessing = 15,
};

/// Transitions that somebody may ask for; the node itself finishes them.
namespace transition_id {
inline constexpr std::uint8_t kConfigure = 1;
inline constexpr std::uint8_t kCleanup = 2;
inline constexpr std::uint8_t kActivate = 3;
inline constexpr std::uint8_t kDeactivate = 4;
inline constexpr std::uint8_t kUnconfiguredShutdown = 5;
inline constexpr std::uint8_t kInactiveShutdown = 6;
inline constexpr std::uint8_t kActiveShutdown = 7;
}  // namespace transition_id

struct Transition {
  std::uint8_t id = 0;
  std::string_view label;
  State start = State::unknown;
  State goal = State::unknown;
};

/// How the work of a transition ended. `failure`: back where it came from; `error`: what is left is unknown.
enum class Outcome { success, failure, error };

[[nodiscard]] std::span<const State> states();
[[nodiscard]] std::string_view label(State state);
[[nodiscard]] std::span<const Transition> transitions();
/// Those that begin at `state`.
[[nodiscard]] std::vector<Transition> transitions_from(State state);
/// The transition that a request means: the label decides, the id only where there is none. Null when `from`
/// has no such transition; a transitional state has none that may be asked for.
[[nodiscard]] const Transition* requested_transition(State from, std::uint8_t id, std::string_view label);
/// How a transition ends whose work ended so. `state` is transitional; throws std::logic_error for any other.
[[nodiscard]] const Transition& finishing_transition(State state, Outcome outcome);

}  // namespace bw::lifecycle
