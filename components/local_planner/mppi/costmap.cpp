#include "components/local_planner/mppi/costmap.hpp"

#include <algorithm>
#include <cmath>

#include "components/model/mover_weight.hpp"

namespace bw::mppi {
namespace {

constexpr double kFar = 1e9;       // [m]
constexpr double kCell = 0.05;     // [m] side of a cell, as Nav2 ships it
constexpr double kMaxAside = 120;  // cells on each side of the robot's

/// Distances from the middles of cells to what is added, as far as it is nearer than `enough` [m].
class Distances {
 public:
  Distances(Eigen::Index aside, double resolution, double enough)
      : aside_(aside), resolution_(resolution), enough_(enough) {
    const Eigen::Index side = 2 * aside + 1;
    of_points_ = Eigen::ArrayXXd::Constant(side, side, kFar);
    of_bodies_ = Eigen::ArrayXXd::Constant(side, side, kFar);
    middles_ =
        Eigen::ArrayXd::LinSpaced(side, -static_cast<double>(aside), static_cast<double>(aside)) * resolution;
  }

  void add_point(const Vector2& p) {
    rows_of(p, p, 0.0, [&](Eigen::Index row, Eigen::Index first, Eigen::Index count) {
      const double dy = middles_[row] - p.y();
      auto cells = of_points_.col(row).segment(first, count);
      cells = cells.min((middles_.segment(first, count) - p.x()).square() + dy * dy);
    });
  }

  void add_disc(const Vector2& p, double radius) {
    rows_of(p, p, radius, [&](Eigen::Index row, Eigen::Index first, Eigen::Index count) {
      const double dy = middles_[row] - p.y();
      auto cells = of_bodies_.col(row).segment(first, count);
      cells = cells.min(((middles_.segment(first, count) - p.x()).square() + dy * dy).sqrt() - radius);
    });
  }

  void add_segment(const Segment& s) {
    const Vector2 axis = s.b - s.a;
    const double square = axis.squaredNorm();
    if (square < 1e-18) return add_point(s.a);
    rows_of(s.a.cwiseMin(s.b), s.a.cwiseMax(s.b), 0.0,
            [&](Eigen::Index row, Eigen::Index first, Eigen::Index count) {
              const double dy = middles_[row] - s.a.y();
              const auto dx = middles_.segment(first, count) - s.a.x();
              const Eigen::ArrayXd share = ((dx * axis.x() + dy * axis.y()) / square).max(0.0).min(1.0);
              auto cells = of_points_.col(row).segment(first, count);
              cells = cells.min((dx - share * axis.x()).square() + (dy - share * axis.y()).square());
            });
  }

  Eigen::ArrayXXd merged() const { return of_points_.sqrt().min(of_bodies_); }

 private:
  // visit(row, first column, how many) for the cells of a box, widened by what is near to it.
  template <class Visit>
  void rows_of(const Vector2& low, const Vector2& high, double radius, Visit&& visit) const {
    const double aside = radius + enough_;
    const auto cell = [&](double coordinate) {
      const double limit = static_cast<double>(aside_) + 1.0;
      return aside_ + static_cast<Eigen::Index>(std::clamp(coordinate / resolution_, -limit, limit));
    };
    // A cell more on either side, for what the conversion cuts off.
    const Eigen::Index last = 2 * aside_;
    const Eigen::Index left = std::clamp<Eigen::Index>(cell(low.x() - aside) - 1, 0, last + 1);
    const Eigen::Index right = std::clamp<Eigen::Index>(cell(high.x() + aside) + 1, -1, last);
    const Eigen::Index bottom = std::clamp<Eigen::Index>(cell(low.y() - aside) - 1, 0, last + 1);
    const Eigen::Index top = std::clamp<Eigen::Index>(cell(high.y() + aside) + 1, -1, last);
    if (left > right) return;
    for (Eigen::Index row = bottom; row <= top; ++row) visit(row, left, right - left + 1);
  }

  Eigen::Index aside_;
  double resolution_;
  double enough_;
  Eigen::ArrayXd middles_;
  Eigen::ArrayXXd of_points_;  ///< squared
  Eigen::ArrayXXd of_bodies_;
};

}  // namespace

double inflated_cost(double distance, double robot_radius, const InflationOptions& options) {
  if (distance <= robot_radius) return kInscribed;
  if (distance >= options.inflation_radius) return 0.0;
  return kMaxWithout * std::exp(-options.kCostScalingFactor * (distance - robot_radius));
}

Costmap::Costmap(const PlanningProblem& problem, const InflationOptions& options, double reach, bool movers) {
  const double resolution = std::max(kCell, reach / kMaxAside);
  const auto aside = static_cast<Eigen::Index>(std::ceil(reach / resolution));
  const double radius = problem.footprint.radius;
  Distances distances(aside, resolution, std::max(options.inflation_radius, radius));
  const Pose2 X_BO = inverse(problem.pose);
  for (const Vector2& p : problem.obstacles.points) distances.add_point(X_BO * p);
  for (const Disc& d : problem.obstacles.discs) distances.add_disc(X_BO * d.center, d.radius);
  for (const Segment& s : problem.obstacles.segments) distances.add_segment({X_BO * s.a, X_BO * s.b});
  for (const Mover& m : problem.movers) {
    if (movers && is_confirmed(m)) distances.add_disc(X_BO * m.position, m.radius);
  }
  cost_ =
      distances.merged().unaryExpr([&](double distance) { return inflated_cost(distance, radius, options); });
  middle_ = static_cast<double>(aside) + 0.5;
  side_ = static_cast<double>(2 * aside + 1);
  per_metre_ = 1.0 / resolution;
}

PredictedCosts::PredictedCosts(const PlanningProblem& problem, const InflationOptions& options, double reach,
                               double horizon)
    : options_(options), pose_(problem.pose), robot_radius_(problem.footprint.radius) {
  for (const Mover& m : problem.movers) {
    const double near = reach + std::max(options.inflation_radius, robot_radius_) + m.radius;
    const double gap = (m.position - pose_.position()).norm() - near;
    if (is_confirmed(m) && gap < horizon * m.top_speed()) movers_.push_back(m);
  }
}

void PredictedCosts::raise(Eigen::Ref<const Eigen::ArrayXd> x, Eigen::Ref<const Eigen::ArrayXd> y,
                           double time, Eigen::ArrayXd& costs) const {
  if (movers_.empty()) return;
  const Pose2 X_BO = inverse(pose_);
  Eigen::ArrayXd distance = Eigen::ArrayXd::Constant(x.size(), kFar);
  for (const Mover& m : movers_) {
    const Vector2 p = X_BO * m.position_at(time);
    distance = distance.min(((x - p.x()).square() + (y - p.y()).square()).sqrt() - m.radius);
  }
  for (Eigen::Index i = 0; i < distance.size(); ++i) {
    if (distance[i] < options_.inflation_radius || distance[i] <= robot_radius_)
      costs[i] = std::max(costs[i], inflated_cost(distance[i], robot_radius_, options_));
  }
}

}  // namespace bw::mppi
