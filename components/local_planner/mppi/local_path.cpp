#include "components/local_planner/mppi/local_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "components/model/nearest_point.hpp"

namespace bw::mppi {
namespace {

constexpr double kSpacing = 0.05;  // [m]
constexpr double kMaxPoints = 400;
constexpr double kRounding = 1e-9;  // [m]

struct PointOnPlan {
  std::size_t leg = 0;  ///< it lies before pose `leg` + 1
  Vector2 point;
};

PointOnPlan nearest_on_plan(const std::vector<Pose2>& plan, const Vector2& robot) {
  PointOnPlan nearest{plan.size() - 1, plan.back().position()};
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < plan.size(); ++i) {
    const Vector2 p = nearest_point(Segment{plan[i].position(), plan[i + 1].position()}, robot);
    if ((robot - p).norm() >= smallest) continue;
    smallest = (robot - p).norm();
    nearest = {i, p};
  }
  return nearest;
}

}  // namespace

LocalPath local_path(const std::vector<Pose2>& plan, const Pose2& robot, double length,
                     const Costmap& costmap) {
  LocalPath path;
  path.spacing = std::max(kSpacing, length / kMaxPoints);
  const auto most = static_cast<std::size_t>(std::lround(length / path.spacing)) + 1;
  PointOnPlan nearest = nearest_on_plan(plan, robot.position());
  std::vector<Vector2> points{nearest.point};
  double to_next = path.spacing;
  for (std::size_t i = nearest.leg + 1; i < plan.size() && points.size() < most; ++i) {
    const Vector2 end = plan[i].position();
    double leg = (end - nearest.point).norm();
    while (leg >= to_next - kRounding && points.size() < most) {
      nearest.point += (to_next / leg) * (end - nearest.point);
      points.push_back(nearest.point);
      leg = std::max(0.0, leg - to_next);
      to_next = path.spacing;
    }
    to_next -= leg;
    nearest.point = end;
  }
  const bool at_a_point = to_next > path.spacing - kRounding;
  if (points.size() < most && !at_a_point) points.push_back(nearest.point);

  const Pose2 X_BO = inverse(robot);
  const auto count = static_cast<Eigen::Index>(points.size());
  path.x.resize(count);
  path.y.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vector2 p = X_BO * points[static_cast<std::size_t>(i)];
    path.x[i] = p.x();
    path.y[i] = p.y();
    path.free.push_back(!costmap.touches(p.x(), p.y()));
  }
  return path;
}

Eigen::Index furthest_reached(const LocalPath& path, Eigen::Ref<const Eigen::ArrayXd> x,
                              Eigen::Ref<const Eigen::ArrayXd> y) {
  Eigen::ArrayXd smallest = Eigen::ArrayXd::Constant(x.size(), std::numeric_limits<double>::infinity());
  Eigen::ArrayXi nearest = Eigen::ArrayXi::Zero(x.size());
  Eigen::ArrayXd distance(x.size());
  for (Eigen::Index j = 0; j < path.size(); ++j) {
    distance = (x - path.x[j]).square() + (y - path.y[j]).square();
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      if (distance[i] >= smallest[i]) continue;
      smallest[i] = distance[i];
      nearest[i] = static_cast<int>(j);
    }
  }
  return nearest.maxCoeff();
}

}  // namespace bw::mppi
