// The goals of the graph itself, driven one after the other; times are counted from activate().
//
//   goals.activate(now);
//   if (const auto X_MG = goals.due(now)) goals.taken(navigator.accept(*X_MG, situation));
//   for (const GoalReport& report : ...) remaining = goals.see(report, now);
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "components/navigator/goal_messages.hpp"

namespace bw {

struct GoalListOptions {
  std::vector<Pose2> goals;      ///< of base_link in map
  double delay = 0.0;            ///< before the first [s]
  double pause = 0.0;            ///< from the end of one to the next [s]
  int loops = 0;                 ///< how often the whole list is driven again
  bool stop_on_failure = false;  ///< a goal that is not reached is the last
};

class GoalList {
 public:
  explicit GoalList(GoalListOptions options) : options_(std::move(options)) {}

  void activate(Time now) { next_at_ = now + Duration::seconds(options_.delay); }

  /// The clock went back by so much.
  void shift(Duration back) { next_at_ = next_at_ - back; }

  /// The goal to be taken up now.
  [[nodiscard]] std::optional<Pose2> due(Time now) const {
    if (in_hand_ || remaining() == 0 || now < next_at_) return std::nullopt;
    return options_.goals[next_ % options_.goals.size()];
  }
  /// Since when the goal that is due waits to be taken.
  [[nodiscard]] Time due_since() const { return next_at_; }

  void taken(std::uint64_t goal_id) {
    in_hand_ = goal_id;
    ++next_;
  }

  /// How many goals of the list follow the one that the report is about: 0 for a goal that is not of the list.
  std::uint32_t see(const GoalReport& report, Time now) {
    if (report.goal_id != in_hand_) return 0;
    if (is_final(report.status)) {
      in_hand_.reset();
      next_at_ = now + Duration::seconds(options_.pause);
      if (report.status != GoalStatus::succeeded && options_.stop_on_failure) give_up();
    }
    return static_cast<std::uint32_t>(remaining());
  }

  /// Somebody else says where to go: what is left of the list is not driven.
  void give_up() { next_ = total(); }

 private:
  [[nodiscard]] std::size_t total() const {
    return options_.goals.size() * (static_cast<std::size_t>(options_.loops) + 1);
  }
  [[nodiscard]] std::size_t remaining() const { return total() - next_; }

  GoalListOptions options_;
  std::size_t next_ = 0;  ///< of all goals, loops one after the other
  std::optional<std::uint64_t> in_hand_;
  Time next_at_;
};

}  // namespace bw
