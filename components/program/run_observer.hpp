// The run verb's own component: follows the score card and the true path of each robot, shows progress on one
// line, ends the run when the goals are decided.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/score_card.hpp>

#include "components/evaluation/thinning.hpp"
#include "components/program/course_observer.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/component.hpp"

namespace bw {

/// Where the robot truly was, in map.
struct PathPoint {
  Time time;
  Pose2 X_MB;
};

/// What the observer has seen of one robot.
struct RobotObservation {
  std::string robot;        ///< empty: the only one
  std::string card_topic;   ///< where it is judged
  std::string truth_topic;  ///< where the judge has it from
  std::optional<bandwagon_msgs::msg::ScoreCard> card = std::nullopt;
  std::vector<PathPoint> path = {};  ///< by rising time, thinned; before a drive the last second
  Thinning thinning{Duration::milliseconds(100)};
};

/// Shared with the verb, read after the run.
struct Observation {
  std::vector<RobotObservation> robots;

  /// Of all robots together.
  std::optional<bandwagon_msgs::msg::ScoreCard> card() const;
};

class RunObserver final : public Component {
 public:
  /// `show_progress`: write the progress line to stderr, with `planner_ms`, the planner's last known median
  /// cycle time. With `stays` the run goes on when the goal is decided. `courses`: of each robot, in their
  /// order; may be none.
  RunObserver(std::shared_ptr<Observation> seen, bool show_progress, bool stays,
              std::function<double()> planner_ms, std::vector<CourseListener> courses = {})
      : seen_(std::move(seen)),
        show_progress_(show_progress),
        stays_(stays),
        planner_ms_(std::move(planner_ms)),
        courses_(std::move(courses)) {}

  void configure(Setup& setup) override;

 private:
  void listen(Setup& setup, std::size_t index);
  void show(const bandwagon_msgs::msg::ScoreCard& card, Time now);

  std::shared_ptr<Observation> seen_;
  bool show_progress_;
  bool stays_;
  std::function<double()> planner_ms_;
  std::vector<CourseListener> courses_;
  std::optional<Time> started_;
  std::function<void(bool, const std::string&)> finish_run_;
};

}  // namespace bw
