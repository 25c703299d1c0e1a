// Where to go next until the map is closed: the state machine of exploring, without maps and messages.
#pragma once

#include <cstdint>
#include <optional>
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

struct ExplorerOptions {
  double gain_scale = 1.0;     ///< [m] of path that a metre of frontier is worth
  bool return_to_init = true;  ///< when it is complete
};

/// What is to be done with the goal.
struct ExploreStep {
  bool cancels = false;       ///< the goal that is driven to
  std::optional<Pose2> goal;  ///< takes the place of what was driven to
};

class Explorer {
 public:
  explicit Explorer(const ExplorerOptions& options) : options_(options) {}

  /// Begins, or goes on; after it was complete it begins anew. `robot`: where it returns to, when it begins.
  void resume(const Pose2& robot);
  /// Stops until resume().
  ExploreStep pause();

  /// With each map, and once a second without a goal: a goal is given up when its frontier has vanished. Nothing while
  /// paused or complete.
  ExploreStep look(const FrontierSearch& search);
  /// The goal of the last step ended. A frontier that was not reached, or that is still there though the robot stood
  /// before it, is put on the blacklist; what was not reached gets a second chance when nothing else is left.
  void goal_ended(bool reached);

  ExploreState state() const { return state_; }
  /// Of the search that was looked at: frontiers that are left out, by the blacklist or out of reach.
  std::size_t given_up() const { return given_up_; }
  std::size_t goals() const { return goals_; }    ///< that were sent
  std::size_t failed() const { return failed_; }  ///< of these, that were not reached

 private:
  bool is_blacklisted(const Frontier& frontier) const;
  const Frontier* best(const std::vector<Frontier>& frontiers) const;

  ExplorerOptions options_;
  ExploreState state_ = ExploreState::paused;
  std::optional<Pose2> start_;
  std::optional<Vector2> target_;   ///< centre of the frontier that is driven to
  std::optional<Vector2> reached_;  ///< of the last one; once it is seen again it is for nothing
  int looks_since_ = 0;             ///< since it was reached
  std::vector<Vector2> failures_;   ///< not reached
  std::vector<Vector2> useless_;    ///< reached, and still there; or failed twice
  bool second_chance_ = false;      ///< was given
  std::size_t given_up_ = 0;
  std::size_t goals_ = 0;
  std::size_t failed_ = 0;
};

}  // namespace bw::explore
