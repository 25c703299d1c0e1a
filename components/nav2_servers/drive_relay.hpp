// What the navigator orders, as goals of Nav2's servers: which goal is to be sent, which canceled, and how
// the order fares. One server drives the robot at a time: a goal of the other one is sent when all of this
// one have ended. A path that replaces another one is sent at once, since the server preempts without a stop.
// One that replaces a failed one counts as failed too until it has been driven for a while: whoever renews
// the path of a controller that always gives up would never hear of it.
//
//   relay.order(7, FollowMode::follow);
//   const RelayActions actions = relay.step(ready, now);
//   ... relay.acknowledged(actions.send->number, true); ... relay.ended(number, end);
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "components/navigator/goal_messages.hpp"

namespace bw {

/// Which servers are there.
struct ServersReady {
  bool follow_path = false;
  bool back_up = false;
};

/// How a goal of a server ended.
struct ServerEnd {
  GoalStatus status = GoalStatus::unknown;  ///< unknown: the server is gone, or took no notice
  std::uint16_t error_code = 0;
  std::string text;  ///< of the server, where it gave one
};

struct RelayGoal {
  std::uint64_t number = 0;
  FollowMode mode = FollowMode::follow;  ///< or back_off
};

struct RelayActions {
  std::vector<std::uint64_t> cancel;  ///< numbers of goals
  std::optional<RelayGoal> send;
  bool clear_costmap = false;  ///< the controller failed: what it saw may be long gone
};

class DriveRelay {
 public:
  /// A newer order replaces the one before.
  void order(std::uint64_t id, FollowMode mode);
  void acknowledged(std::uint64_t number, bool accepted);
  void ended(std::uint64_t number, const ServerEnd& end);
  /// Everything is to stop, and nothing is awaited.
  RelayActions stop();

  /// What is to be done since the last call.
  RelayActions step(const ServersReady& ready, Time now);
  /// Of the newest order.
  FollowReport report() const { return {order_id_, state_, reason_, error_code_}; }

 private:
  struct Open {
    FollowMode mode;
    Time sent;
    bool acknowledged = false;
    std::optional<Time> canceled = std::nullopt;  ///< when it was last asked for
  };

  void fail(const std::string& reason, std::uint16_t error_code = 0);
  bool is_other_server_busy() const;

  std::uint64_t order_id_ = 0;
  FollowMode mode_ = FollowMode::stop;
  FollowState state_ = FollowState::idle;
  std::string reason_;
  std::uint16_t error_code_ = 0;
  bool is_asked_ = true;     ///< the newest order was sent to its server, if there is one
  bool is_doubted_ = false;  ///< its predecessor failed

  std::uint64_t last_number_ = 0;
  std::uint64_t current_ = 0;  ///< the goal of the newest order; 0: not sent
  std::map<std::uint64_t, Open> open_;
  bool clear_costmap_ = false;
};

/// Why a goal of `server` did not succeed, in one sentence.
std::string failure_sentence(const std::string& server, const ServerEnd& end);

/// What the navigator is told of a plan that failed with this code of compute_path_to_pose or
/// compute_path_through_poses.
PlanOutcome outcome_of(std::uint16_t error_code);

}  // namespace bw
