// A leaf that has an action done, with the timing of nav2_behavior_tree's action node: 5 ms of a tick are
// waited for an acknowledgement, 20 ms in all, then the leaf fails; a goal may be replaced by a new one while
// it runs.
#pragma once

#include <functional>
#include <optional>

#include "tests/interop/nav2_tree/journal.hpp"
#include "tests/interop/nav2_tree/messages.hpp"
#include "tests/interop/plain/action_client.hpp"

namespace nav2 {

inline constexpr std::chrono::milliseconds kServerTimeout{20};  ///< default_server_timeout
inline constexpr std::chrono::milliseconds kCancelTimeout{50};  ///< default_cancel_timeout
inline constexpr std::chrono::milliseconds kWaitInTick{5};      ///< half of bt_loop_duration
inline constexpr std::chrono::microseconds kLook{100};

/// What differs from action to action.
struct PostedTask {
  std::string action;  ///< follow_path
  std::string type;    ///< nav2_msgs/action/FollowPath
  std::function<Bytes()> goal;
  std::function<std::optional<Bytes>()> new_goal = [] { return std::nullopt; };  ///< while it runs
  std::function<Outcome(const Bytes&)> read;                                     ///< the reply of get_result
  std::function<void(const Outcome&)> on_end = [](const Outcome&) {};  ///< succeeded, aborted or canceled
};

class ActionLeaf final : public TreeNode {
 public:
  ActionLeaf(plain::Node& node, Journal& journal, PostedTask errand);

  plain::ActionClient& client() { return client_; }
  const std::string& action() const { return errand_.action; }
  /// Takes what has come, so that its time is known; between ticks too.
  void poll();

 private:
  struct Sent {
    plain::GoalId id;
    std::int64_t request = 0;
    Clock::time_point at;
    std::optional<plain::Acknowledgement> answer = std::nullopt;
    std::int64_t result_request = 0;
    std::optional<Outcome> end = std::nullopt;
  };

  Status on_tick() override;
  void on_halt() override;
  void send(const Bytes& goal);
  Status acknowledged();
  void poll_acknowledgement();
  bool wait_until(Clock::time_point end, const std::function<bool()>& seen);
  Status ended();
  void note_end(const Sent& goal, bool was_replaced);

  Journal& journal_;
  PostedTask errand_;
  plain::ActionClient client_;
  std::optional<Sent> pending_;  ///< sent, and not yet acknowledged
  std::optional<Sent> running_;
  std::vector<Sent> replaced_;
  std::uint32_t count_ = 0;
};

}  // namespace nav2
