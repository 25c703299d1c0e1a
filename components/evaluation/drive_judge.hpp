// Judges a drive from its beginning to its end: the score card, the error of the pose, and what the picture
// needs.
// A drive begins with a goal and ends with it, or with the last of several that follow each other. A judge of
// a whole run goes on from the first goal to the end of the run; the outcome is that of the last goal.
#pragma once

#include <cstdint>
#include <string>

#include "components/evaluation/pose_errors.hpp"
#include "components/evaluation/run_recorder.hpp"
#include "components/evaluation/score_keeper.hpp"

namespace bw {

/// What the navigator says of a goal.
struct GoalNews {
  std::uint64_t goal_id = 0;  ///< rises from goal to goal
  bool is_over = false;
  bool is_claimed = false;     ///< over, and the robot says that it stands there
  bool others_follow = false;  ///< goals of the same drive
  std::string reason;
  Vector2 goal{0.0, 0.0};  ///< in map [m]
  GoalTolerance tolerance;
};

class DriveJudge {
 public:
  enum class Lasts { until_goal, until_end_of_run };

  /// `top_speed` [m/s].
  DriveJudge(const EvaluationOptions& options, const Footprint& robot, double top_speed,
             Lasts lasts = Lasts::until_goal)
      : lasts_(lasts), keeper_(options, robot), recorder_(robot, top_speed) {}

  /// A drive without a goal, such as that of a recording, lasts until end_run().
  void begin_run(Time now);
  void end_run(Time now);
  /// True when it ends the drive, or one of the goals of a whole run.
  bool on_goal(const GoalNews& news, Time now);
  /// The goal takes the place of the one that is being driven to, which is not over.
  bool is_preempting(const GoalNews& news) const {
    return running() && news.goal_id > goal_id_ && !news.is_over && !others_follow_;
  }
  void on_truth(const TruthSample& sample);
  /// Nobody knows where the robot is until the next sample.
  void lose_pose() { keeper_.lose_pose(); }
  /// The robot's outline from now on.
  void on_footprint(const Footprint& footprint) {
    keeper_.set_footprint(footprint);
    recorder_.set_footprint(footprint);
  }
  /// Where the robot believes to be in map at `time`.
  void on_pose(Time time, const Pose2& X_MB);

  bool running() const { return keeper_.running(); }
  /// Of a whole run: a goal is being driven to.
  bool has_goal() const { return has_goal_; }
  const ScoreCard& card() const { return keeper_.card(); }
  const PoseErrors& pose_errors() const { return errors_; }
  RunRecorder& recorder() { return recorder_; }

 private:
  void begin(const GoalNews& news, Time now);
  bool on_goal_of_run(const GoalNews& news, Time now);

  Lasts lasts_;
  ScoreKeeper keeper_;
  PoseErrors errors_;
  RunRecorder recorder_;
  std::uint64_t goal_id_ = 0;
  bool others_follow_ = false;
  bool has_goal_ = false;
};

}  // namespace bw
