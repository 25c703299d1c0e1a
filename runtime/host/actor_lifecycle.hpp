// Moves the component of one actor through its states: each transition is plain calls of the component,
// between its callbacks, on its lane. What is not active hears nothing, ticks not, and its outputs are mute;
// its ends on the wire stay, so that a component that comes up again finds its place as it left it.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "runtime/base/time.hpp"
#include "runtime/lifecycle/state_machine.hpp"

namespace bw {

struct Actor;
class Component;
class Runner;

/// What the host does for it.
struct LifecycleMeans {
  /// A new instance, not configured yet. Empty: the one that is there is the only one.
  std::function<std::unique_ptr<Component>()> make;
  /// Configures a new instance on the ends that the actor has. Throws std::exception when it cannot.
  std::function<void(Component&)> configure;
  /// Hears of every change.
  std::function<void(const lifecycle::Transition& transition, Time now)> tell;
  std::function<void(const std::string& text)> log_error;
  /// Who else is there under the node's name or with its servers; empty text: nobody. It is not activated
  /// beside one.
  std::function<std::string()> rivals;
};

class ActorLifecycle {
 public:
  ActorLifecycle(Actor& actor, LifecycleMeans means) : actor_(actor), means_(std::move(means)) {}

  /// Outputs go there. Before the first transition.
  void connect(Runner& runner) { runner_ = &runner; }
  /// While the run goes on transitions are told, and timers begin with them; before and after it the host
  /// does as much for all at once.
  void set_running(bool is_running) { is_running_ = is_running; }
  /// The configured instance that is there waits for its first `configure`, and serves then.
  void wait_for_configure();
  /// What the instance read when it was configured has changed: the next `configure` makes a new one.
  void forget_parameters() { instance_is_ready_ = false; }

  /// Takes a transition of the table that begins at the actor's state. Empty when it succeeded, else why not:
  /// then the state is the one before, after an error `unconfigured`, and in every case the outputs of what
  /// is not active are mute.
  std::string change(const lifecycle::Transition& transition, Time now);

 private:
  void enter(const lifecycle::Transition& transition, Time now);
  std::string work(const lifecycle::Transition& transition, Time now);
  void configure();
  void activate(Time now);
  void deactivate(Time now);
  void cleanup();
  void mute();
  void forget_messages(Time now);
  void give_up();
  void destroy();
  void begin_hearing(Time now);

  Actor& actor_;
  LifecycleMeans means_;
  Runner* runner_ = nullptr;
  bool is_running_ = false;
  bool instance_is_ready_ = false;
};

}  // namespace bw
