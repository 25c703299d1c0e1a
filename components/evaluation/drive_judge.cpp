#include "components/evaluation/drive_judge.hpp"

#include <limits>
#include <utility>

namespace bw {

void DriveJudge::begin_run(Time now) {
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  keeper_.start(now, {kNowhere, kNowhere});
  errors_ = {};
  recorder_.start(now);
}

void DriveJudge::end_run(Time now) {
  if (lasts_ == Lasts::until_end_of_run) return keeper_.close();
  keeper_.finish(now, false, "the run is over");
}

bool DriveJudge::on_goal_of_run(const GoalNews& news, Time now) {
  if (news.goal_id > goal_id_ && (!news.is_over || !has_goal_)) {
    others_follow_ = running();
    begin(news, now);
    has_goal_ = true;
  }
  if (!news.is_over || news.goal_id != goal_id_ || !has_goal_) return false;
  has_goal_ = false;
  keeper_.end_goal(news.is_claimed, news.reason);
  return true;
}

bool DriveJudge::on_goal(const GoalNews& news, Time now) {
  if (lasts_ == Lasts::until_end_of_run) return on_goal_of_run(news, now);
  if (news.goal_id > goal_id_ && (!news.is_over || !running())) begin(news, now);
  if (!news.is_over || news.goal_id != goal_id_ || !running()) return false;
  others_follow_ = news.others_follow;
  if (others_follow_) {
    keeper_.end_leg(news.is_claimed);
    return false;
  }
  keeper_.finish(now, news.is_claimed, news.reason);
  return true;
}

void DriveJudge::begin(const GoalNews& news, Time now) {
  goal_id_ = news.goal_id;
  if (std::exchange(others_follow_, false)) {
    keeper_.next_leg(news.goal, news.tolerance);
    recorder_.add_goal(news.goal);
    return;
  }
  keeper_.start(now, news.goal, news.tolerance);
  errors_ = {};
  recorder_.start(now, news.goal);
}

void DriveJudge::on_truth(const TruthSample& sample) {
  if (!running()) return;
  keeper_.add(sample);
  errors_.set_truth(sample);
  recorder_.add(sample);
}

void DriveJudge::on_pose(Time time, const Pose2& X_MB) {
  if (running()) errors_.add(time, X_MB);
}

}  // namespace bw
