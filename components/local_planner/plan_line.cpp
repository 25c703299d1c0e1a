#include "components/local_planner/plan_line.hpp"

#include <algorithm>
#include <limits>

namespace bw {

PlanLine::PlanLine(const std::vector<Pose2>& plan, const Vector2& robot, double beyond) {
  const auto add = [&](const Vector2& point) {
    const double leg = points_.empty() ? 0.0 : (point - points_.back()).norm();
    if (!points_.empty() && leg == 0.0) return;
    along_.push_back(points_.empty() ? 0.0 : along_.back() + leg);
    points_.push_back(point);
  };
  for (const Pose2& pose : plan) add(pose.position());
  if (points_.size() == 1) {
    points_.clear();
    along_.clear();
    add(robot);
    add(plan.back().position());
  }
  length_ = along_.back();
  const Vector2 last_leg = points_.size() > 1
                               ? Vector2((points_.back() - points_[points_.size() - 2]).normalized())
                               : direction(plan.back().theta);
  const Vector2 end = points_.back();
  add(end + std::max(beyond, 1e-3) * last_leg);
}

PlanLine::Projection PlanLine::nearest(const Vector2& point, double from, double to) const {
  from = std::clamp(from, 0.0, along_.back());
  to = std::clamp(to, from, along_.back());
  const auto begin = std::upper_bound(along_.begin() + 1, along_.end() - 1, from);
  Projection best{from, std::numeric_limits<double>::infinity()};
  double least = std::numeric_limits<double>::infinity();
  for (auto i = static_cast<std::size_t>(begin - along_.begin()); i < points_.size(); ++i) {
    if (along_[i - 1] > to) break;
    const double length = along_[i] - along_[i - 1];
    const Vector2 leg = (points_[i] - points_[i - 1]) / length;
    const double share = std::clamp((point - points_[i - 1]).dot(leg), std::max(0.0, from - along_[i - 1]),
                                    std::min(length, to - along_[i - 1]));
    const double squared = (point - points_[i - 1] - share * leg).squaredNorm();
    if (squared >= least) continue;
    least = squared;
    best.along = along_[i - 1] + share;
  }
  best.beside = std::sqrt(least);
  return best;
}

Vector2 PlanLine::at(double along) const {
  along = std::clamp(along, 0.0, along_.back());
  const auto i = static_cast<std::size_t>(std::upper_bound(along_.begin() + 1, along_.end() - 1, along) -
                                          along_.begin());
  const double share = (along - along_[i - 1]) / (along_[i] - along_[i - 1]);
  return points_[i - 1] + share * (points_[i] - points_[i - 1]);
}

}  // namespace bw
