// Where to go next until the map is closed: the state machine of exploring, without maps and messages.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "components/explore/frontier_search.hpp"

namespace bw::explore {

enum class ExploreState : std::uint8_t {
  paused,
  exploring,  ///< drives to a frontier, or looks for one
  returning,  ///< nothing is left: back to where it began
  complete
};
/// In the words of explore_lite's status.
std::string_view to_string(ExploreState state);

/// What is to be done with the goal.
struct ExploreStep {
  bool cancels = false;       ///< the goal that is driven to
  std::optional<Pose2> goal;  ///< takes the place of what was driven to
};

/// How a goal ended.
enum class GoalEnd : std::uint8_t {
  reached,
  failed,
  dropped  ///< by a fault of the robot, which says nothing of the frontier: it did not know where it was, it was held
};

/// A frontier that nobody drives to any more.
struct LeftFrontier {
  Vector2 centre{0.0, 0.0};
  std::string why;
};

class Explorer {
 public:
  /// `return_to_init`: back to where it began when nothing is left.
  explicit Explorer(bool return_to_init = true) : return_to_init_(return_to_init) {}

  /// Begins, or goes on; after it was complete it begins anew. `robot`: where it returns to, when it begins.
  void resume(const Pose2& robot);
  /// Stops until resume().
  ExploreStep pause();

  /// With each map, and once a second without a goal in hand: the nearest frontier by path is driven to, whichever that
  /// is by now. Nothing while paused or complete.
  ExploreStep look(const FrontierSearch& search);
  /// The goal of the last step ended. A frontier that was not reached, or that is still there though the robot stood
  /// before it, comes onto the blacklist. When nothing else is left, all on it get a second chance, once.
  void goal_ended(GoalEnd end, const std::string& why);

  ExploreState state() const { return state_; }
  /// Looks for a frontier to drive to, or whether none is left.
  bool is_idle() const { return state_ == ExploreState::exploring && (!target_ || empty_looks_ > 0); }
  /// Of the search that was looked at: frontiers that are on the blacklist or out of reach, and why.
  const std::vector<LeftFrontier>& left() const { return left_; }
  std::size_t goals() const { return goals_; }    ///< that were sent
  std::size_t failed() const { return failed_; }  ///< of these, that were not reached

 private:
  struct Failure {
    Vector2 place{0.0, 0.0};
    std::string why;
    int times = 1;
  };

  bool stands_before_it(const std::vector<Frontier>& frontiers);
  void blacklist(const Vector2& place, const std::string& why);
  const Failure* blacklisted(const Frontier& frontier) const;
  const Frontier* nearest(const std::vector<Frontier>& frontiers) const;
  void take_stock(const FrontierSearch& search);
  ExploreStep nothing_left();

  bool return_to_init_;
  ExploreState state_ = ExploreState::paused;
  std::optional<Pose2> start_;
  std::optional<Vector2> target_;   ///< centre of the frontier that is driven to
  Pose2 goal_;                      ///< that was sent for it
  std::optional<Vector2> reached_;  ///< the frontier before which the robot stands
  int looks_ = 0;                   ///< since then
  int empty_looks_ = 0;             ///< one after the other, with nothing to drive to
  std::vector<Failure> blacklist_;
  bool second_chance_ = false;  ///< was given
  std::vector<LeftFrontier> left_;
  std::size_t goals_ = 0;
  std::size_t failed_ = 0;
};

}  // namespace bw::explore
