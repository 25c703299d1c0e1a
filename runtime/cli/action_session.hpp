// One goal of an action, from its sending to its end, for a program of the command line. Every wait ends
// within 100 ms, so that the program can look for Ctrl-C.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/cli/action_layout.hpp"
#include "runtime/ros/notifier.hpp"
#include "runtime/ros/service_call.hpp"

namespace bw::cli {

class ActionSession {
 public:
  using Bytes = std::vector<std::uint8_t>;

  /// Chooses a random id.
  ActionSession(dds::Participant& participant, const std::string& action, const ActionLayout& layout);

  const GoalId& id() const { return id_; }
  /// In hexadecimal, as ROS 2 prints it.
  std::string id_text() const;

  /// The three services and the feedback are connected.
  bool is_ready() const;
  /// False: the server's ends have gone.
  bool is_served() const { return get_result_.is_ready(); }

  /// `request` is a SendGoal request, whatever its goal_id.
  void send(Bytes request);
  /// Whether the goal is accepted; nothing as long as nobody has said so. Accepted, its result is asked for.
  std::optional<bool> take_acknowledgement();
  void cancel();
  /// action_msgs/srv/CancelGoal's return_code.
  std::optional<std::int8_t> take_cancel_code();
  /// The next FeedbackMessage about this goal.
  std::optional<Bytes> take_feedback();
  /// The response of GetResult.
  std::optional<Bytes> take_result();

  /// Until something has come.
  void wait() { notifier_.wait(std::chrono::steady_clock::now() + std::chrono::milliseconds(100)); }

 private:
  Notifier notifier_;
  GoalId id_;
  ServiceCaller send_goal_, cancel_goal_, get_result_;
  std::unique_ptr<dds::Reader> feedback_;
  std::optional<std::int64_t> sent_, canceled_, asked_;
};

}  // namespace bw::cli
