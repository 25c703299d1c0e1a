// One action of one actor: three services and two topics under `<name>/_action`, and the goals between them.
// Requests are answered apart from the actor's lane, in every state of the component; goals and cancels wait
// here for its turn.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "runtime/base/ros_distro.hpp"
#include "runtime/host/input_endpoint.hpp"
#include "runtime/ports.hpp"
#include "runtime/ros/goal_book.hpp"

namespace bw {

class OutputEnd;
class Runner;
class ServiceEnd;

class ActionEnd final : public InputEndpoint, public ActionPort {
 public:
  /// The ends that others see. They are the actor's.
  struct Ends {
    ServiceEnd* send_goal = nullptr;
    ServiceEnd* cancel_goal = nullptr;
    ServiceEnd* get_result = nullptr;
    OutputEnd* feedback = nullptr;
    OutputEnd* status = nullptr;
  };
  /// As rcl_action keeps results: 15 min in Humble, 10 s later.
  static Duration result_timeout(RosDistro distro);

  ActionEnd(Actor& owner, std::string declared, std::string resolved, const ActionType& action_type,
            const Ends& ends, Duration keep_results);

  const std::string& label() const override { return action; }
  bool take_one(Time now, std::optional<Duration> waited) override;

  ServicePort& send_goal_port() override;
  ServicePort& cancel_goal_port() override;
  ServicePort& get_result_port() override;
  bool offer(const GoalId& id, std::shared_ptr<const void> goal, Time now) override;
  CanceledGoals cancel(const CancelRequest& request, Time now) override;
  void send_result(const GoalId& id, const RequestId& to, Time now) override;

  bool is_open(const GoalId& id) const override;
  bool is_canceling(const GoalId& id) const override;
  void execute(const GoalId& id) override;
  void feedback(const GoalId& id, std::span<const std::uint8_t> cdr) override;
  void finish(const GoalId& id, GoalStatus end, std::vector<std::uint8_t> result) override;

  /// Every open goal ends aborted: who worked on them does so no more.
  void abandon(const std::string& reason, Time now);

  std::string name;      ///< as the component declared it
  std::string action;    ///< resolved, absolute
  bool of_node = false;  ///< declared by the runtime, not by the component
  ActionType type;
  Runner* runner = nullptr;
  ActionHandler handler;
  Ends ends;

 private:
  struct News {
    GoalId id{};
    bool is_cancel = false;
  };

  // With `mutex_` held.
  void end(const GoalId& id, GoalStatus how, std::vector<std::uint8_t> result, Time now);
  void publish_status(Time now);

  mutable std::mutex mutex_;
  GoalBook book_;
  std::map<GoalId, std::shared_ptr<const void>> goals_;  ///< open ones
  std::map<GoalId, std::vector<RequestId>> awaited_;     ///< who waits for which result
  std::deque<News> news_;                                ///< for the component
  std::set<GoalId> ended_;  ///< by the component in the callback that runs; on its lane only
};

}  // namespace bw
