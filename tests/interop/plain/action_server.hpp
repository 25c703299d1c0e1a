// The answering end of a ROS 2 action as rclcpp's server behaves; what becomes of a goal, its test decides.
#pragma once

#include <functional>
#include <map>

#include "tests/interop/plain/action.hpp"

namespace plain {

class ActionServer {
 public:
  /// Appends the fields of a result behind its status.
  using Fields = std::function<void(CdrOut&)>;

  /// `no_result`: a result's fields when all are zero.
  ActionServer(Node& node, const std::string& action, const ActionType& type, Fields no_result);
  ~ActionServer();
  ActionServer(const ActionServer&) = delete;
  ActionServer& operator=(const ActionServer&) = delete;

  /// Answers what has come; to be called often.
  void answer();
  /// Goals that have been accepted, in their order; `bytes` is the request.
  struct Goal {
    GoalState state;
    Bytes bytes;
    std::optional<Bytes> result = std::nullopt;
    std::vector<rtps::SampleIdentity> waiting = {};  ///< for the result
  };
  std::vector<Goal>& goals() { return goals_; }
  Goal* find(const GoalId& id);

  void execute(const GoalId& id) { set_status(id, GoalStatus::executing); }
  /// `feedback` is a message of its own.
  void feedback(const GoalId& id, const Bytes& feedback);
  void finish(const GoalId& id, GoalStatus status, const Fields& result);

  std::function<bool(const Bytes& request)> accepts = [](const Bytes&) { return true; };
  bool grants_cancels = true;

 private:
  void set_status(const GoalId& id, GoalStatus status);
  void publish_status();
  void answer_goal(const Request& request);
  void answer_cancel(const Request& request);
  void answer_result(const Request& request);

  Node& node_;
  Fields no_result_;
  Server send_goal_, cancel_goal_, get_result_;
  dds::DataWriter* feedback_writer_;
  dds::DataWriter* status_writer_;
  std::vector<Goal> goals_;
  std::int32_t clock_ = 100;  ///< stamps of acceptance count goals [s]
};

}  // namespace plain
