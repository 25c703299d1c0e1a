// Critics that hold a motion to the plan.
#include <algorithm>
#include <cmath>

#include "components/local_planner/mppi/critics.hpp"

namespace bw::mppi {
namespace {

// So many are never too many.
constexpr Eigen::Index kFewTaken = 2;

bool is_blocked(const LocalPath& path, Eigen::Index count, double most) {
  const auto taken = std::count(path.free.begin(), path.free.begin() + count, false);
  return taken > kFewTaken && static_cast<double>(taken) > most * static_cast<double>(count);
}

}  // namespace

void add_path_align_cost(const PathAlignOptions& options, const CriticScene& scene, const Rollouts& motions,
                         Eigen::ArrayXd& costs) {
  if (options.cost_weight <= 0.0 || scene.goal_distance < options.kBeyond) return;
  const LocalPath& path = scene.path;
  const Eigen::Index count = scene.furthest;  // points in use
  if (count < 1 || count < options.kFromPoint) return;
  if (is_blocked(path, count, options.kMaxTaken)) return;

  const Eigen::Index samples = motions.samples();
  const double last = static_cast<double>(count - 1);
  Eigen::ArrayXd along = Eigen::ArrayXd::Zero(samples), sum = along, counted = along;
  for (Eigen::Index k = options.kPointStep, before = 0; k < motions.steps();
       before = k, k += options.kPointStep) {
    along += ((motions.x.col(k) - motions.x.col(before)).square() +
              (motions.y.col(k) - motions.y.col(before)).square())
                 .sqrt();
    for (Eigen::Index i = 0; i < samples; ++i) {
      const auto point = static_cast<Eigen::Index>(std::min(along[i] / path.spacing + 0.5, last));
      if (!path.free[static_cast<std::size_t>(point)]) continue;
      const double dx = path.x[point] - motions.x(i, k), dy = path.y[point] - motions.y(i, k);
      sum[i] += std::sqrt(dx * dx + dy * dy);
      counted[i] += 1.0;
    }
  }
  costs += options.cost_weight * sum / counted.max(1.0);
}

void add_path_follow_cost(const PathFollowOptions& options, const CriticScene& scene, const Rollouts& motions,
                          Eigen::ArrayXd& costs) {
  const LocalPath& path = scene.path;
  if (options.cost_weight <= 0.0 || scene.goal_distance < options.kBeyond || path.size() < 2) return;
  const Eigen::Index last = path.size() - 1;
  Eigen::Index point = std::min<Eigen::Index>(scene.furthest + options.kAhead, last);
  while (point < last && !path.free[static_cast<std::size_t>(point)]) ++point;
  const Eigen::Index end = motions.steps() - 1;
  costs +=
      options.cost_weight *
      ((motions.x.col(end) - path.x[point]).square() + (motions.y.col(end) - path.y[point]).square()).sqrt();
}

void add_path_angle_cost(const PathAngleOptions& options, const CriticScene& scene, const Rollouts& motions,
                         Eigen::ArrayXd& costs) {
  if (options.cost_weight <= 0.0 || scene.goal_distance < options.kBeyond) return;
  const LocalPath& path = scene.path;
  const Eigen::Index point = std::min<Eigen::Index>(scene.furthest + options.kAhead, path.size() - 1);
  const double x = path.x[point], y = path.y[point];
  if (std::abs(std::atan2(y, x)) < options.kOffHeading) return;
  const Eigen::Index end = motions.steps() - 1;
  for (Eigen::Index i = 0; i < costs.size(); ++i) {
    const double bearing = std::atan2(y - motions.y(i, end), x - motions.x(i, end));
    costs[i] += options.cost_weight * std::abs(wrap_angle(bearing - motions.theta(i, end)));
  }
}

}  // namespace bw::mppi
