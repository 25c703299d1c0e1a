#include "components/people/detector/disc_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

namespace bw::people {
namespace {

constexpr int kIterations = 5;
constexpr std::size_t kMaxPoints = 24;  // more of them change a centre by less than a millimetre
constexpr double kEdgeFloor = 0.005;    // [m]
constexpr double kStart = 0.1;          // how far the centre may be from where it is first looked for [m]
constexpr double kLongestStep = 0.1;    // of an iteration [m]
constexpr double kModel = 0.008;        // legs are no circles: standard deviation of the centre [m]

/// One arc: some points, and the edges of it that can be seen.
struct Arc {
  std::span<const Vector2> points;
  const Vector2* right_ray = nullptr;
  const Vector2* left_ray = nullptr;
};

class Equations {
 public:
  void add(double residual, const Eigen::Vector3d& gradient, double sigma) {
    const double weight = 1.0 / (sigma * sigma);
    information_ += weight * gradient * gradient.transpose();
    right_side_ -= weight * residual * gradient;
  }
  Eigen::Vector3d step() const { return information_.ldlt().solve(right_side_); }
  Eigen::Matrix3d covariance() const { return information_.inverse(); }

 private:
  Eigen::Matrix3d information_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_side_ = Eigen::Vector3d::Zero();
};

DiscFit fit(const Arc& arc, const Outline& outline, const LegFitOptions& legs) {
  const std::size_t count = arc.points.size();
  const std::size_t stride = (count + kMaxPoints - 1) / kMaxPoints;
  // Points left out count through those kept.
  const double point_sigma = legs.kRangeNoise / std::sqrt(static_cast<double>(stride));
  const double edge_sigma = std::max(kEdgeFloor, outline.spacing / std::sqrt(12.0));
  Vector2 mean{0.0, 0.0};
  for (const Vector2& p : arc.points) mean += p;
  mean /= static_cast<double>(count);

  const Eigen::Vector3d start(mean.x() + 0.75 * legs.kRadius, mean.y(), legs.kRadius);  // centre and radius
  Eigen::Vector3d x = start;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    Equations equations;
    for (std::size_t i = 0; i < count; i += stride) {
      const Vector2 offset = x.head<2>() - arc.points[i];
      const double length = std::max(offset.norm(), 1e-6);
      equations.add(length - x[2], {offset.x() / length, offset.y() / length, -1.0}, point_sigma);
    }
    const Vector2 from_scanner = x.head<2>() - outline.scanner();
    if (arc.right_ray != nullptr) {
      const Vector2& u = *arc.right_ray;
      equations.add(cross(u, from_scanner) - x[2], {-u.y(), u.x(), -1.0}, edge_sigma);
    }
    if (arc.left_ray != nullptr) {
      const Vector2& u = *arc.left_ray;
      equations.add(-cross(u, from_scanner) - x[2], {u.y(), -u.x(), -1.0}, edge_sigma);
    }
    equations.add(x[2] - legs.kRadius, {0.0, 0.0, 1.0}, legs.kRadiusSigma);
    // Two points without an edge leave the centre open along a line.
    equations.add(x[0] - start[0], {1.0, 0.0, 0.0}, kStart);
    equations.add(x[1] - start[1], {0.0, 1.0, 0.0}, kStart);
    Eigen::Vector3d step = equations.step();
    if (const double length = step.norm(); length > kLongestStep) step *= kLongestStep / length;
    x += step;
    x[2] = std::max(x[2], 0.01);
    covariance = equations.covariance();
    if (step.squaredNorm() < 1e-8) break;
  }
  DiscFit result;
  result.center = x.head<2>();
  result.radius = x[2];
  result.covariance = covariance.topLeftCorner<2, 2>() + kModel * kModel * Eigen::Matrix2d::Identity();
  double sum = 0.0;
  for (const Vector2& p : arc.points) {
    const double residual = (p - result.center).norm() - result.radius;
    sum += residual * residual;
  }
  result.residual = std::sqrt(sum / static_cast<double>(count));
  return result;
}

}  // namespace

DiscFit fit_disc(const Outline& outline, const LegFitOptions& legs) {
  return fit({outline.points, outline.right.occluded ? nullptr : &outline.right_ray,
              outline.left.occluded ? nullptr : &outline.left_ray},
             outline, legs);
}

DiscFit fit_two_discs(const Outline& outline, const LegFitOptions& legs) {
  constexpr std::size_t kMaxCuts = 12;
  const std::size_t count = outline.points.size();
  if (count < 2) return fit_disc(outline, legs);
  const std::span<const Vector2> points = outline.points;
  const std::size_t stride = (count - 1 + kMaxCuts - 1) / kMaxCuts;
  DiscFit best;
  double best_cost = std::numeric_limits<double>::infinity();
  for (std::size_t cut = std::max<std::size_t>(1, stride / 2); cut < count; cut += stride) {
    // The nearer leg's edge at the cut could be seen too, but which one is nearer is what is asked here.
    const DiscFit right = fit(
        {points.first(cut), outline.right.occluded ? nullptr : &outline.right_ray, nullptr}, outline, legs);
    const DiscFit left = fit(
        {points.subspan(cut), nullptr, outline.left.occluded ? nullptr : &outline.left_ray}, outline, legs);
    const auto points_cost = [&](const DiscFit& side, std::size_t n) {
      return static_cast<double>(n) * std::pow(side.residual / legs.kRangeNoise, 2.0) +
             std::pow((side.radius - legs.kRadius) / legs.kRadiusSigma, 2.0);
    };
    const double cost = points_cost(right, cut) + points_cost(left, count - cut);
    if (cost >= best_cost) continue;
    best_cost = cost;
    best.center = (right.center + left.center) / 2.0;
    best.covariance = (right.covariance + left.covariance) / 4.0;
    best.radius = (right.radius + left.radius) / 2.0;
    best.residual = std::sqrt((static_cast<double>(cut) * right.residual * right.residual +
                               static_cast<double>(count - cut) * left.residual * left.residual) /
                              static_cast<double>(count));
  }
  return best;
}

}  // namespace bw::people
