// A navigator in a world of one line: planners answer as told, the robot drives or does not.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "components/navigator/navigator.hpp"

namespace bw {

/// A robot on a line with planners that answer as told. Steps of 50 ms.
class Drive {
 public:
  explicit Drive(const NavigatorOptions& options = {}) : navigator(options) {}

  Situation situation() const {
    return {now,           lost ? std::nullopt : std::optional(Pose2{x, 0.0, 0.0}),
            {v, 0.0},      two_sigma,
            is_overridden, base_stop};
  }

  /// Sends what the navigator wants sent; planners answer at once through it.
  void exchange() {
    for (int guard = 0; guard < 20; ++guard) {
      const NavigatorActions actions = navigator.step(situation());
      for (const GoalReport& report : actions.reports) reports.push_back(report);
      if (actions.follow) {
        orders.push_back(*actions.follow);
        v = 0.0;
        if (actions.follow->mode == FollowMode::follow) v = speed;
        if (actions.follow->mode == FollowMode::back_off) v = -0.1;
      }
      if (!actions.plan) return;
      plans.push_back(*actions.plan);
      plan_times.push_back(now);
      if (answer_plans)
        navigator.on_plan(
            {actions.plan->id, outcome, outcome_reason, path(actions.plan->X_MG), plan_error_code},
            situation());
    }
    FAIL() << "the navigator orders without end";
  }

  std::vector<Pose2> path(const Pose2& X_MG) const {
    if (outcome != PlanOutcome::succeeded || empty_plans) return {};
    return {{x, 0, 0}, X_MG};
  }

  std::uint64_t go_through(std::vector<Pose2> via, double goal) {
    goal_x = goal;
    const std::uint64_t id = navigator.accept({{goal, 0, 0}, std::move(via)}, situation());
    exchange();
    return id;
  }
  std::size_t poses_remaining() const { return navigator.report(situation()).poses_remaining; }

  void run(double seconds) {
    const Time end = now + Duration::seconds(seconds);
    while (now < end) {
      now = now + Duration::milliseconds(50);
      if (follow_state == FollowState::blocked && v > 0.0) v = 0.0;
      if (base_stop) v = 0.0;
      x += v * 0.05;
      if (goal_x && v > 0.0 && x >= *goal_x) {
        x = *goal_x;
        v = 0.0;
      }
      if (report_follow && !orders.empty()) {
        navigator.on_follow({orders.back().id, follow_state, "two people in the way", error_code},
                            situation());
      }
      exchange();
    }
  }

  std::uint64_t go_to(double goal) {
    goal_x = goal;
    const std::uint64_t id = navigator.accept({goal, 0, 0}, situation());
    exchange();
    return id;
  }

  int count(FollowMode mode) const {
    return static_cast<int>(
        std::count_if(orders.begin(), orders.end(), [mode](const FollowOrder& o) { return o.mode == mode; }));
  }
  const GoalReport& last() const { return reports.back(); }

  Navigator navigator;
  Time now = Time::seconds(100.0);
  double x = 0.0;
  double v = 0.0;
  double speed = 1.0;
  bool is_overridden = false;         ///< by a hand
  std::optional<BaseStop> base_stop;  ///< wheels stand whatever is ordered
  bool lost = false;
  double two_sigma = 0.0;  ///< of its position [m]
  std::optional<double> goal_x;
  bool answer_plans = true;
  bool empty_plans = false;
  bool report_follow = true;
  PlanOutcome outcome = PlanOutcome::succeeded;
  std::string outcome_reason;
  std::uint16_t plan_error_code = 0;
  FollowState follow_state = FollowState::following;
  std::uint16_t error_code = 0;  ///< of the reports
  std::vector<GoalReport> reports;
  std::vector<FollowOrder> orders;
  std::vector<PlanOrder> plans;
  std::vector<Time> plan_times;
};

inline std::vector<GoalStatus> statuses(const std::vector<GoalReport>& reports, std::uint64_t goal) {
  std::vector<GoalStatus> list;
  for (const GoalReport& report : reports) {
    if (report.goal_id == goal) list.push_back(report.status);
  }
  return list;
}

}  // namespace bw
