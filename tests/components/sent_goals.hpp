// A script's goals of an action in lock-step, and what became of each.
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/components/component_rig.hpp"

namespace bw {

/// Does things at their moments [s since the start], multiples of 0.01, in this order.
inline void at_times(Setup& setup, std::vector<std::pair<double, std::function<void()>>> acts) {
  setup.every(Duration::milliseconds(10), "acts",
              [acts = std::move(acts), next = std::size_t{0}](const Tick& tick) mutable {
                constexpr double kRounding = 1e-6;
                while (next < acts.size() && seconds_since_start(tick.now) > acts[next].first - kRounding)
                  acts[next++].second();
              });
}

template <class A>
class SentGoals {
 public:
  struct Goal {
    GoalId id{};
    int acknowledged = 0;
    bool accepted = false;
    std::vector<typename A::Feedback> feedback;
    std::vector<GoalStatus> ends;  ///< one, once it ended
    typename A::Result result;     ///< of the end
    double ended_at = 0.0;         ///< [s] since the start
  };

  void declare(Setup& setup, const std::string& name) {
    client_ = setup.action_client<A>(name);
    goals.clear();
  }
  Goal& send(const typename A::Goal& goal) {
    Goal& sent = goals.emplace_back();
    sent.id =
        client_.send(goal, Duration::milliseconds(500),
                     {.on_acknowledged =
                          [&sent](bool accepted, const Tick&) {
                            ++sent.acknowledged;
                            sent.accepted = accepted;
                          },
                      .on_feedback = [&sent](const typename A::Feedback& feedback,
                                             const Tick&) { sent.feedback.push_back(feedback); },
                      .on_result =
                          [&sent](GoalStatus status, const typename A::Result* result, const Tick& tick) {
                            sent.ends.push_back(status);
                            sent.ended_at = seconds_since_start(tick.now);
                            if (result != nullptr) sent.result = *result;
                          }});
    return sent;
  }
  void cancel(std::size_t index) { client_.cancel(goals[index].id); }

  std::deque<Goal> goals;  ///< whose places stay

 private:
  ActionClient<A> client_;
};

}  // namespace bw
