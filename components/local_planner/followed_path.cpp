#include "components/local_planner/followed_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "components/local_planner/path_corners.hpp"
#include "components/model/nearest_point.hpp"

namespace bw {
namespace {

// The robot is looked for along the path beyond what it has driven: twice as far as it may leave the path,
// since who cuts a bend comes further along the path than it drives, and this far at most [m].
constexpr double kReach = 3.0;
constexpr double kAhead = 1.0;      // [m] at which the way on is seen from a corner
constexpr double kOffPath = 0.4;    // [m] within which the robot counts as on the path
constexpr double kStep = 0.1;       // [m] between the positions of the path that are compared with a chord
constexpr double kCloser = 1e-6;    // [m] from which one point is nearer than another
constexpr double kFacing = 0.3;     // [rad] within which the robot faces the way on
constexpr double kNoBearing = 0.1;  // [m] nearer than which the way on has no direction
// A stretch of more than this much of its chord and kLoop [m] comes back to where it began.
constexpr double kStraightness = 2.0;
constexpr double kLoop = 0.5;

double distance(const Vector2& a, const Vector2& b) { return (a - b).norm(); }

}  // namespace

void FollowedPath::start(std::vector<Pose2> poses) {
  const double travelled = travelled_;
  *this = {};
  travelled_ = travelled;
  poses_ = std::move(poses);
  if (poses_.empty()) return;
  line_.emplace(poses_, poses_.front().position(), 0.0);
  along_.push_back(0.0);
  for (std::size_t i = 1; i < poses_.size(); ++i)
    along_.push_back(along_.back() + distance(poses_[i].position(), poses_[i - 1].position()));
  corners_ = sharp_corners(poses_, along_, *line_);
}

const PathLeg& FollowedPath::leg(const Pose2& X_PB, const FollowLimits& limits) {
  leg_ = {.poses = {}, .goal_is_final = true, .tolerance = limits.tolerance, .begins = false};
  if (poses_.empty()) return leg_;
  const Vector2 robot = X_PB.position();
  advance(robot, limits);
  if (!rotate_first(X_PB)) cut(robot, limits);
  return leg_;
}

void FollowedPath::advance(const Vector2& robot, const FollowLimits& limits) {
  const bool begins = !robot_;
  const double reach =
      std::min(kReach, 2.0 * limits.max_deviation) + (begins ? 0.0 : distance(robot, *robot_));
  robot_ = robot;
  for (bool goes_on = true; goes_on;) {
    const bool moved = advance_once(robot, reach);
    const bool passed = pass_corner(robot, limits.tolerance.xy);
    if (passed && !begins) leg_.begins = is_rotating_ = true;
    goes_on = begins && (moved || passed);
  }
  const double before = distance_to_goal_;
  measure(robot);
  if (!begins) travelled_ += before - distance_to_goal_;
}

bool FollowedPath::advance_once(const Vector2& robot, double reach) {
  const double beside = distance(line_->at(progress_), robot);
  const PlanLine::Projection projection =
      line_->nearest(robot, progress_, std::min(progress_ + reach, along_[leg_end()]));
  if (projection.beside > beside - kCloser) return false;
  progress_ = projection.along;
  return true;
}

bool FollowedPath::pass_corner(const Vector2& robot, double tolerance) {
  if (is_on_last_leg() || distance(poses_[leg_end()].position(), robot) > tolerance) return false;
  if (along_[leg_end()] - progress_ > kStraightness * tolerance + kLoop) return false;
  progress_ = along_[leg_end()];
  ++corner_;
  return true;
}

void FollowedPath::measure(const Vector2& robot) {
  const auto first = along_.begin() + static_cast<std::ptrdiff_t>(corner_ == 0 ? 0 : corners_[corner_ - 1]);
  const auto last = along_.begin() + static_cast<std::ptrdiff_t>(leg_end());
  auto nearest = std::lower_bound(first, last, progress_);
  if (nearest != first && progress_ - nearest[-1] <= *nearest - progress_) --nearest;
  index_ = static_cast<std::size_t>(nearest - along_.begin());
  distance_to_goal_ = distance(poses_[index_].position(), robot);
  for (std::size_t i = index_ + 1; i < poses_.size(); ++i)
    distance_to_goal_ += distance(poses_[i - 1].position(), poses_[i].position());
}

bool FollowedPath::rotate_first(const Pose2& X_PB) {
  if (!is_rotating_) return false;
  const Vector2 ahead = line_->at(std::min(progress_ + kAhead, along_[leg_end()])) - X_PB.position();
  const double heading = std::atan2(ahead.y(), ahead.x());
  is_rotating_ = ahead.norm() > kNoBearing && std::abs(wrap_angle(heading - X_PB.theta)) > kFacing;
  if (!is_rotating_) return false;
  leg_.poses = {{X_PB.x, X_PB.y, heading}};
  leg_.tolerance.yaw = kFacing;
  return true;
}

void FollowedPath::cut(const Vector2& robot, const FollowLimits& limits) {
  const std::size_t last = leg_end();
  const double from = along_[index_] - distance(poses_[index_].position(), robot);
  std::size_t end = index_;
  while (end < last && along_[end] - from < limits.lookahead) ++end;
  const double straight = straight_until(along_[end], limits.max_deviation);
  for (std::size_t i = index_; i <= end && along_[i] <= straight; ++i) leg_.poses.push_back(poses_[i]);
  leg_.goal_is_final = end == last && along_[end] <= straight;
  if (along_[end] > straight) {
    if (leg_.poses.empty()) leg_.poses.push_back(pose_at(progress_));
    leg_.poses.push_back(pose_at(straight));
  } else if (!is_on_last_leg() && end == last) {
    leg_.poses.back() = pose_at(along_[last]);  // faces the corner, and not the way on
  }
}

double FollowedPath::straight_until(double end, double max_deviation) const {
  // From the robot; but one that was driven off the path shall see as far as one beside it.
  const Vector2 point = line_->at(progress_);
  const Vector2 beside = *robot_ - point;
  const Vector2 from = point + beside * (kOffPath / std::max(beside.norm(), kOffPath));
  std::vector<Vector2> between;
  for (double along = progress_ + kStep; along < end + kStep; along += kStep) {
    const double here = std::min(along, end);
    const Segment chord{from, line_->at(here)};
    const bool leaves = std::any_of(between.begin(), between.end(), [&](const Vector2& p) {
      return distance(nearest_point(chord, p), p) > max_deviation;
    });
    if (leaves || here - progress_ > kStraightness * distance(chord.a, chord.b) + kLoop) return along - kStep;
    between.push_back(chord.b);
  }
  return std::numeric_limits<double>::infinity();
}

Pose2 FollowedPath::pose_at(double along) const {
  const Vector2 here = line_->at(along);
  const Vector2 in = here - line_->at(along - kNoBearing);
  return {here.x(), here.y(), std::atan2(in.y(), in.x())};
}

}  // namespace bw
