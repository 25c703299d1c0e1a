// The asking end of a ROS 2 action, step by step: what rcl_action's client does, for a test to do at any time
// and in any order.
#pragma once

#include <chrono>

#include "tests/interop/plain/action.hpp"

namespace plain {

struct Acknowledgement {
  bool is_accepted = false;
  Stamp stamp;
};

struct CancelReply {
  CancelCode code = CancelCode::none;
  std::vector<GoalInfo> canceling;
};

struct Result {
  GoalStatus status = GoalStatus::unknown;
  CdrIn fields;  ///< behind the status
  Bytes bytes;   ///< the whole reply
};

struct Feedback {
  GoalId id{};
  CdrIn fields;  ///< behind the id
  Bytes bytes;
};

class ActionClient {
 public:
  ActionClient(Node& node, const std::string& action, const ActionType& type);
  ~ActionClient();
  ActionClient(const ActionClient&) = delete;
  ActionClient& operator=(const ActionClient&) = delete;

  /// The three services are there and both topics are connected.
  bool is_ready() const;
  bool wait_until_ready(std::chrono::milliseconds limit = kLimit) const;

  /// `goal` is a message of its own. Each waits for its answer; nothing when none came.
  std::optional<Acknowledgement> send(const GoalId& id, const Bytes& goal);
  std::optional<CancelReply> cancel(const GoalInfo& which);
  std::optional<Result> result(const GoalId& id);

  /// The same in two steps: the count of the request, and its reply once it is there.
  std::int64_t ask_goal(const GoalId& id, const Bytes& goal) { return goals_.send(with_goal_id(id, goal)); }
  std::optional<Acknowledgement> take_goal(std::int64_t asked);
  std::int64_t ask_cancel(const GoalInfo& which);
  std::optional<CancelReply> take_cancel(std::int64_t asked);
  std::int64_t ask_result(const GoalId& id);
  std::optional<Result> take_result(std::int64_t asked);

  /// Everything heard since the beginning, in the order in which it came.
  const std::vector<std::vector<GoalState>>& status_lists();
  const std::vector<Feedback>& feedback();
  /// What the lists said of one goal, each status once.
  std::vector<GoalStatus> history(const GoalId& id);

  Client& goal_service() { return goals_; }
  Client& cancel_service() { return cancels_; }
  Client& result_service() { return results_; }

  static constexpr std::chrono::milliseconds kLimit{10'000};

 private:
  Node& node_;
  std::string action_;
  Client goals_, cancels_, results_;
  dds::DataReader* feedback_reader_;
  dds::DataReader* status_reader_;
  std::vector<std::vector<GoalState>> status_lists_;
  std::vector<Feedback> feedback_;
};

}  // namespace plain
