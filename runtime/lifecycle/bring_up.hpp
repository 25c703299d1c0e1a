// What a manager does with its nodes, step by step: which node is asked for which transition next, given how
// the steps before went. The commands are those of nav2_msgs/ManageLifecycleNodes.
//
//   startup    configure all, then activate all, in order      pause    deactivate all, backwards
//   resume     activate all, in order                          reset    deactivate, then clean up all, backwards
//   configure  configure all, in order                         cleanup  clean up all, backwards
//   shutdown   deactivate, clean up, shut down all, backwards
//
// A node that is where the step leads already is passed over. The way up ends at the first node that fails,
// and what is active by then is deactivated backwards: half a graph does not drive. The way down goes on with
// the others: they can still be brought to rest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "runtime/lifecycle/state_machine.hpp"

namespace bw::lifecycle {

enum class Command : std::uint8_t {
  startup = 0,
  pause = 1,
  resume = 2,
  reset = 3,
  shutdown = 4,
  configure = 5,
  cleanup = 6,
};

/// Nothing when no command has this number.
[[nodiscard]] std::optional<Command> command_of(std::uint8_t number);

class BringUp {
 public:
  struct Step {
    std::size_t node = 0;  ///< in the order of bring-up
    std::string_view transition;
    std::uint8_t id = 0;  ///< 0 where the node has no such transition
    State from = State::unknown;
    State goal = State::unknown;  ///< once it succeeded
  };

  /// `nodes`: their states now, in the order of bring-up.
  BringUp(Command command, std::vector<State> nodes);

  /// The step to take now; nothing when there is none left. The same until finished() is called.
  [[nodiscard]] std::optional<Step> next();
  /// The step that next() named left its node in `now`.
  void finished(State now);

  /// The first step that did not succeed.
  [[nodiscard]] const std::optional<Step>& failure() const { return failure_; }
  [[nodiscard]] const std::vector<State>& nodes() const { return nodes_; }

 private:
  struct Phase {
    std::string_view transition;
    bool backwards = false;
  };

  static std::vector<Phase> phases_of(Command command);
  void fail(const Step& step);

  std::vector<State> nodes_;
  std::vector<Phase> phases_;
  std::vector<Phase> when_it_fails_;
  std::size_t phase_ = 0;
  std::size_t position_ = 0;
  std::optional<Step> failure_;
};

}  // namespace bw::lifecycle
