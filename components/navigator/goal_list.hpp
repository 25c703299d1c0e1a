// Goals driven one after the other, with a stop at each: those of the graph itself, and those of
// follow_waypoints. Times are counted from activate().
//
//   goals.activate(now);
//   if (const auto X_MG = goals.due(now)) goals.taken(navigator.accept({*X_MG}, situation));
//   for (const GoalReport& report : ...) remaining = goals.see(report, now);
//   if (goals.end() != GoalList::End::none) ...
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "components/navigator/goal_messages.hpp"

namespace bw {

struct GoalListOptions {
  std::vector<Pose2> goals;      ///< of base_link in map
  double delay = 0.0;            ///< before the first [s]
  double pause = 0.0;            ///< from the end of one to the next [s]
  std::uint32_t loops = 0;       ///< how often the whole list is driven again
  bool stop_on_failure = false;  ///< a goal that is not reached is the last
  std::size_t first = 0;  ///< index of the goal that the first round begins with; below the number of goals
};

/// A goal of the list that was not reached.
struct MissedGoal {
  std::size_t index = 0;  ///< in the list
  GoalReport report;
};

class GoalList {
 public:
  /// completed: every goal was tried. stopped: one was missed, and it is the last. given_up: by whoever else
  /// says where to go, or by a cancel.
  enum class End { none, completed, stopped, given_up };

  explicit GoalList(GoalListOptions options) : options_(std::move(options)), next_(options_.first) {}

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
    current_ = next_ % options_.goals.size();
    ++next_;
  }

  /// How many goals of the list follow the one that the report is about: 0 for a goal that is not of the
  /// list.
  std::uint32_t see(const GoalReport& report, Time now) {
    if (report.goal_id != in_hand_) return 0;
    if (is_final(report.status)) {
      in_hand_.reset();
      next_at_ = now + Duration::seconds(options_.pause);
      if (report.status != GoalStatus::succeeded) miss(report);
    }
    constexpr std::size_t kMax = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(std::min(remaining(), kMax));
  }

  /// Somebody else says where to go, or nowhere: what is left of the list is not driven.
  void give_up(const std::string& reason) {
    if (end() != End::none || end_ != End::none) return;
    finish(End::given_up);
    end_reason_ = reason;
  }

  /// None as long as a goal of the list is in hand.
  [[nodiscard]] End end() const {
    if (in_hand_) return End::none;
    return remaining() == 0 && end_ == End::none ? End::completed : end_;
  }
  /// One sentence; empty for a list that was completed.
  [[nodiscard]] const std::string& end_reason() const { return end_reason_; }
  /// Index of the goal in hand, or of the last one.
  [[nodiscard]] std::size_t current() const { return current_; }
  /// In the order in which they were missed, loops one after the other.
  [[nodiscard]] const std::vector<MissedGoal>& missed() const { return missed_; }
  [[nodiscard]] const std::vector<Pose2>& goals() const { return options_.goals; }

 private:
  void miss(const GoalReport& report) {
    if (end_ != End::none) return;  // given up before it could be reached
    missed_.push_back({current_, report});
    if (!options_.stop_on_failure) return;
    finish(End::stopped);
    end_reason_ = "goal " + std::to_string(current_) + " of the list was missed: " + report.reason;
  }
  void finish(End end) {
    end_ = end;
    next_ = total();
  }
  [[nodiscard]] std::size_t total() const {
    return options_.goals.size() * (static_cast<std::size_t>(options_.loops) + 1);
  }
  [[nodiscard]] std::size_t remaining() const { return total() - next_; }

  GoalListOptions options_;
  std::size_t next_ = 0;  ///< of all goals, loops one after the other
  std::size_t current_ = 0;
  std::optional<std::uint64_t> in_hand_;
  Time next_at_;
  End end_ = End::none;
  std::string end_reason_;
  std::vector<MissedGoal> missed_;
};

}  // namespace bw
