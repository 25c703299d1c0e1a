// A component and those that follow it, moved through their states as one, as Nav2's servers move the
// costmaps inside them: on the way up the followers go first, on the way down last, each on its own lane by
// its own change_state.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <lifecycle_msgs/srv/change_state.hpp>

#include "runtime/component.hpp"
#include "runtime/lifecycle/bring_up.hpp"

namespace bw {

/// Of one transition. A particle filter over a large map takes its time; who takes longer is broken.
inline constexpr Duration kLongestTransition = Duration::milliseconds(10'000);

struct Actor;

class NestedLifecycle {
 public:
  struct Follower {
    std::string name;
    std::string change_state;  ///< absolute name of its service
    std::function<lifecycle::State()> state;
  };
  using OnDone = std::function<void(bool success)>;

  NestedLifecycle(Actor& leader, std::vector<Follower> followers)
      : leader_(leader), followers_(std::move(followers)) {}

  /// Declares the calls of the followers as ends of the leader's node.
  void configure(Setup& setup);
  /// Takes the leader's `transition`, and the followers with it. `on_done` is called once, on the leader's
  /// lane: at once with false while another transition is under way. When one of them fails on the way up,
  /// nobody stays farther up than the leader.
  void change(const lifecycle::Transition& transition, Time now, OnDone on_done);

 private:
  void step(Time now);
  void end(Time now);
  std::vector<lifecycle::State> states() const;  ///< of the followers, then the leader's
  bool is_behind() const;

  Actor& leader_;
  std::vector<Follower> followers_;
  std::vector<Client<lifecycle_msgs::srv::ChangeState>> clients_;
  std::optional<lifecycle::BringUp> bring_up_;  ///< while a transition is under way
  OnDone on_done_;
  bool failed_ = false;
  Logger log_;
};

}  // namespace bw
